// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/crossing_tracing.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <eliminant/bridge/contacts/crossing_branch.hpp>

namespace eliminant::bridge {

namespace {

using Place = std::array<double, 2>;

/// What is known of the branch in boxes around the crossing, each smaller than the one before.
std::vector<CurveCrossing> nested_crossings(const ContactCurve& curve, const CurveCrossing& crossing) {
  std::vector<CurveCrossing> result{crossing};
  constexpr int most = 6;
  constexpr double shrinking = 0.3;
  double half = crossing.length;
  for (int i = 0; i < most; ++i) {
    half *= shrinking;
    CellBox box;
    for (std::size_t k = 0; k < 4; ++k) {
      box.lower[k] = crossing.parameters[k] - half;
      box.upper[k] = crossing.parameters[k] + half;
    }
    const auto smaller = curve.crossing(box);
    if (smaller && smaller->inside && smaller->branch_bend < result.back().branch_bend) result.push_back(*smaller);
  }
  return result;
}

}  // namespace

TracedArc trace_to_crossing(const ContactCurve& curve, const CrossingPoint& from, const CurveCrossing& crossing,
                            double tolerance, const Context& context) {
  const std::size_t base = curve.swapped() ? 2 : 0;
  TracedArc arc;
  const std::vector<CurveCrossing> known = nested_crossings(curve, crossing);
  const Place start = crossing.coordinates_of({from.parameters[base], from.parameters[base + 1]});
  CrossingBranch branch(curve, crossing);
  const double accuracy = std::max(0.02 * tolerance, 1e-14);
  // The parameters of the branch at the crossing are known to that.
  const double radius = known.back().radius * (1 + crossing.branch_slope) +
                        std::fabs(known.back().origin[0] - crossing.origin[0]) +
                        std::fabs(known.back().origin[1] - crossing.origin[1]);
  double y = start[1];
  double x = start[0];
  double slope = x / y;
  Place last{};
  constexpr std::size_t most_points = 2000000;
  while (arc.points.size() < most_points) {
    if (arc.points.size() % 1024 == 0) context.checkpoint("tracing");
    const auto point = branch.at(x, y, accuracy);
    if (!point) return arc;
    TracedPoint traced;
    for (std::size_t k = 0; k < 4; ++k) traced.parameters[k] = std::clamp(point->parameters[k], 0.0, 1.0);
    traced.point = point->point;
    const Place here{point->parameters[base], point->parameters[base + 1]};
    if (!arc.points.empty()) {
      double least = INFINITY;
      for (const CurveCrossing& box : known) least = std::min(least, curve.chord_error(box, last, here, accuracy));
      arc.error = std::max(arc.error, least);
      const Place before = crossing.coordinates_of(last);
      slope = (point->x - before[0]) / (point->y - before[1]);
    }
    arc.points.push_back(traced);
    last = here;
    double to_crossing = INFINITY;
    double unit = INFINITY;
    for (const CurveCrossing& box : known) {
      to_crossing = std::min(to_crossing, curve.chord_error(box, here, box.origin, accuracy + radius));
      unit = std::min(unit, curve.unit_chord_error(box, here));
    }
    const double step = std::sqrt(0.7 * tolerance / unit);
    if (to_crossing < tolerance || !(step < std::fabs(y))) {
      arc.error = std::max(arc.error, to_crossing);
      break;
    }
    // Not to leave a short one at the end.
    const double next = std::copysign(std::fabs(y) < 2 * step ? 0.5 * std::fabs(y) : std::fabs(y) - step, y);
    x = point->x + slope * (next - y);
    y = next;
  }
  TracedPoint end;
  end.parameters = known.back().parameters;
  end.point = curve.point_at({end.parameters[base], end.parameters[base + 1]});
  arc.points.push_back(end);
  arc.proven = std::isfinite(arc.error);
  return arc;
}

}  // namespace eliminant::bridge
