// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <support/text_patches.hpp>

#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/geometry/nurbs.hpp>

/// Surfaces with known intersections, and what their results must have.
namespace eliminant::test {

using SpacePoint = std::array<double, 3>;
/// At most the distance of a point from a curve.
using CurveDistance = std::function<double(const SpacePoint&)>;

/// Largest at the points of a polyline and between them.
inline double farthest(const intersect::SurfaceComponent& component, const CurveDistance& distance) {
  double result = distance(component.points.front().point);
  for (std::size_t i = 0; i + 1 < component.points.size(); ++i)
    for (int j = 1; j <= 4; ++j) {
      SpacePoint at;
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = std::lerp(component.points[i].point[k], component.points[i + 1].point[k], 0.25 * j);
      result = std::max(result, distance(at));
    }
  return result;
}

inline double length_of(const intersect::SurfaceComponent& component) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < component.points.size(); ++i) {
    const SpacePoint& a = component.points[i].point;
    const SpacePoint& b = component.points[i + 1].point;
    length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  return length;
}

/// The counts as text: curves, loops, points, overlaps, singular points; with the status.
inline std::string summary(const intersect::SurfaceResult& result) {
  std::string text;
  for (const unsigned long count : {result.counts.curves, result.counts.loops, result.counts.points,
                                    result.counts.overlaps, result.counts.singular})
    text += std::to_string(count) + " ";
  return text + (result.status == intersect::Status::certified ? "certified" : "not certified");
}

/// The half x^2 + y^2 = 1, y >= 0, from z = 0 to z = 2, of two pieces that meet at x = 0: u in [0, 2], v in [0, 1].
inline symbolic::ParametricSurface half_cylinder() {
  const symbolic::KnotVector turn{2, {0, 0, 0, 1, 1, 2, 2, 2}};
  const symbolic::KnotVector straight{1, {0, 0, 1, 1}};
  // Quarters (1 - t^2, 2 t) / (1 + t^2), and mirrored with the weights in reverse.
  const std::vector<std::array<long, 3>> arc{{1, 0, 1}, {1, 1, 1}, {0, 2, 2}, {-1, 1, 1}, {-1, 0, 1}};
  std::vector<std::vector<symbolic::ControlPoint>> rows;
  for (const auto& [x, y, w] : arc) rows.push_back({{x, y, 0, w}, {x, y, 2 * w, w}});
  return symbolic::nurbs_surface({turn, straight}, rows);
}

}  // namespace eliminant::test
