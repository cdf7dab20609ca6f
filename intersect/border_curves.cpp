// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/border_curves.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curve_curve.hpp>
#include <eliminant/intersect/curve_surface.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::intersect {

namespace {

/// Of a patch, where the parameter of the axis is 0 or 1; on [0, 1].
symbolic::CurvePiece border_of(const bridge::ExactNet& net, std::size_t axis, int side) {
  const std::size_t row = net.degrees[1] + 1;
  const std::size_t kept = side < 0 ? 0 : net.degrees[axis];
  std::vector<symbolic::ControlPoint> points;
  for (std::size_t i = 0; i <= net.degrees[1 - axis]; ++i) {
    const bridge::ExactPoint& point = net.points[axis == 0 ? kept * row + i : i * row + kept];
    points.emplace_back(point.begin(), point.end());
  }
  return symbolic::bezier_curve(points);
}

symbolic::SurfacePiece patch_of(const bridge::ExactNet& net) {
  const std::size_t row = net.degrees[1] + 1;
  std::vector<std::vector<symbolic::ControlPoint>> rows(net.degrees[0] + 1);
  for (std::size_t i = 0; i < net.points.size(); ++i)
    rows[i / row].emplace_back(net.points[i].begin(), net.points[i].end());
  return symbolic::bezier_patch(rows);
}

double middle(const Coordinate& x) { return arf_get_d(arb_midref(x.ball.real()), ARF_RND_NEAR); }

}  // namespace

std::vector<std::array<double, 2>> BorderCurves::contained(std::size_t axis, int side) const {
  std::vector<std::array<double, 2>> result;
  CurveResult found;
  try {
    const symbolic::ParametricCurve curve{{border_of(axis < 2 ? first_ : second_, axis % 2, side)}};
    const symbolic::ParametricSurface surface{{patch_of(axis < 2 ? second_ : first_)}};
    found = intersect_curve_surface({curve, surface}, Options(), context_);
  } catch (const InvalidInput&) {
    return result;
  }
  for (const Overlap& overlap : found.overlap) {
    if (!overlap.certified || !overlap.t || !(*overlap.t)[0] || !(*overlap.t)[1]) continue;
    result.push_back({middle(*(*overlap.t)[0]), middle(*(*overlap.t)[1])});
  }
  return result;
}

const std::vector<std::array<double, 2>>& BorderCurves::meetings(std::size_t first_axis, int first_side,
                                                                 std::size_t second_axis, int second_side) {
  const PairOfBorders borders{first_axis, first_side, second_axis, second_side};
  const auto known = known_.find(borders);
  if (known != known_.end()) return known->second;
  return known_.emplace(borders, intersect(borders)).first->second;
}

std::vector<std::array<double, 2>> BorderCurves::intersect(const PairOfBorders& borders) const {
  const auto& [first_axis, first_side, second_axis, second_side] = borders;
  std::vector<std::array<double, 2>> result;
  CurveResult found;
  try {
    const symbolic::ParametricCurve a{{border_of(first_, first_axis, first_side)}};
    const symbolic::ParametricCurve b{{border_of(second_, second_axis - 2, second_side)}};
    found = intersect_curve_curve({a, b}, Options(), context_);
  } catch (const InvalidInput&) {
    // A border that is one point.
    return result;
  }
  for (const CurveSolution& solution : found.solutions) {
    if (!solution.certified || !solution.inside || !solution.t || !*solution.t || !solution.u || !*solution.u) continue;
    result.push_back({middle(**solution.t), middle(**solution.u)});
  }
  return result;
}

}  // namespace eliminant::intersect
