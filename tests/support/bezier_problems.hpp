// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>
#include <support/bezier_families.hpp>

namespace eliminant::test {

/// (x, y, z) -> scale (x, y, z) + (shift, -shift, shift), exactly.
struct Similarity {
  symbolic::Rational scale = 1;
  symbolic::Rational shift = 0;
};

inline symbolic::ControlPoint exact_point(const HomogeneousPoint& point, bool plane, const Similarity& similarity) {
  const symbolic::Rational weight = exact_rational(point[3]);
  symbolic::ControlPoint result;
  for (std::size_t k = 0; k < (plane ? 2 : 3); ++k) {
    const symbolic::Rational shift = (k == 1 ? -similarity.shift : similarity.shift) * weight;
    result.push_back(similarity.scale * exact_rational(point[k]) + shift);
  }
  result.push_back(weight);
  return result;
}

inline std::vector<symbolic::ControlPoint> exact_polygon(const ControlPolygon& polygon, bool plane,
                                                         const Similarity& similarity = {}) {
  std::vector<symbolic::ControlPoint> points;
  for (const HomogeneousPoint& point : polygon) points.push_back(exact_point(point, plane, similarity));
  return points;
}

inline std::vector<std::vector<symbolic::ControlPoint>> exact_net(const ControlNet& net,
                                                                  const Similarity& similarity = {}) {
  std::vector<std::vector<symbolic::ControlPoint>> rows;
  for (const ControlPolygon& row : net) rows.push_back(exact_polygon(row, false, similarity));
  return rows;
}

inline intersect::CurveSurfaceProblem curve_surface_problem(const BezierCase& bezier,
                                                            const Similarity& similarity = {}) {
  intersect::CurveSurfaceProblem problem;
  problem.curve.pieces.push_back(symbolic::bezier_curve(exact_polygon(bezier.curve, false, similarity)));
  problem.surface = symbolic::ParametricSurface{{symbolic::bezier_patch(exact_net(bezier.patch, similarity))}};
  return problem;
}

inline intersect::CurveCurveProblem curve_curve_problem(const BezierCase& bezier, const Similarity& similarity = {}) {
  const auto curve = [&](const ControlPolygon& polygon) {
    return symbolic::ParametricCurve{{symbolic::bezier_curve(exact_polygon(polygon, true, similarity))}};
  };
  return {curve(bezier.curve), curve(bezier.second)};
}

}  // namespace eliminant::test
