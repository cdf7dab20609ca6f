// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/border_curves.hpp>

#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/meetings_by_substitution.hpp>
#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/intersect/curves/curve_curve.hpp>
#include <eliminant/intersect/patches/net_patches.hpp>

namespace eliminant::intersect {

namespace {

double middle(const Coordinate& x) { return arf_get_d(arb_midref(x.ball.real()), ARF_RND_NEAR); }

}  // namespace

bridge::ContainedParts BorderCurves::contained(std::size_t axis, int side) const {
  bridge::ContainedParts result;
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
    result.intervals.push_back({middle(*(*overlap.t)[0]), middle(*(*overlap.t)[1])});
  }
  const bool is_whole = result.intervals.size() == 1 && result.intervals[0][0] <= 0 && result.intervals[0][1] >= 1;
  const bool is_known = found.status == Status::infinite && found.rest_status == Status::certified &&
                        result.intervals.size() == found.overlap.size() &&
                        std::none_of(found.solutions.begin(), found.solutions.end(),
                                     [](const CurveSolution& solution) { return solution.inside; });
  result.nothing_else = is_whole || (is_known && !result.intervals.empty());
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
    if (auto meetings = bridge::meetings_by_substitution(a.pieces[0].map, b.pieces[0].map, context_)) return *meetings;
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
