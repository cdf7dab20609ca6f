// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/crossing_tracing.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace eliminant::bridge {

TracedArc trace_to_crossing(const ContactCurve& curve, const CrossingPoint& from, const CurveCrossing& crossing,
                            double tolerance) {
  const std::size_t base = curve.swapped() ? 2 : 0;
  const std::array<double, 2> offset{from.parameters[base] - crossing.origin[0],
                                     from.parameters[base + 1] - crossing.origin[1]};
  const auto cross = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return a[0] * b[1] - a[1] * b[0];
  };
  const double area = cross(crossing.across, crossing.along);
  double x = cross(offset, crossing.along) / area;
  const double start = cross(crossing.across, offset) / area;
  TracedArc arc;
  // The distance grows with the square of the step.
  const double unit_error = curve.chord_error(crossing, 1, 0);
  constexpr double fewest = 2;
  constexpr double most = 1000;
  // Nearer to the crossing the patches can hardly be told apart; a long last chord is far from the branch.
  double last = 0;
  double least_error = std::numeric_limits<double>::infinity();
  for (double y = 0.25 * std::fabs(start); y > 0x1p-14; y *= 0.5) {
    const auto point = curve.branch_point(crossing, x / start * std::copysign(y, start), std::copysign(y, start));
    if (!point) continue;
    const double error = curve.chord_error(crossing, y, point->error);
    if (error < least_error) {
      least_error = error;
      last = y;
    }
  }
  if (last == 0) return arc;
  const double way = std::fabs(start) - last;
  const double steps = std::clamp(std::ceil(way / std::sqrt(0.5 * tolerance / unit_error)), fewest, most);
  const double step = way / steps;
  double worst = 0;
  double slope = x / start;
  for (double i = 0; i <= steps; ++i) {
    const double y = std::copysign(std::fabs(start) - i * step, start);
    auto point = curve.branch_point(crossing, x, y);
    constexpr double poor = 1e-6;
    if (!point || point->error > poor) point = curve.branch_point(crossing, slope * y, y);
    if (!point) return arc;
    worst = std::max(worst, point->error);
    TracedPoint traced;
    for (std::size_t k = 0; k < 4; ++k) traced.parameters[k] = std::clamp(point->parameters[k], 0.0, 1.0);
    traced.point = point->point;
    arc.points.push_back(traced);
    // The next one lies ahead.
    const std::array<double, 2> here{point->parameters[base] - crossing.origin[0],
                                     point->parameters[base + 1] - crossing.origin[1]};
    const double found = cross(here, crossing.along) / area;
    if (i > 0) slope = (found - x) / (-std::copysign(step, start)) + slope;
    if (i == 0) slope = found / start;
    x = found - slope * std::copysign(step, start);
  }
  TracedPoint end;
  end.parameters = crossing.parameters;
  const std::array<double, 3> there = curve.point_at({crossing.origin[0], crossing.origin[1]});
  end.point = there;
  arc.points.push_back(end);
  arc.error = std::max(curve.chord_error(crossing, step, worst),
                       curve.chord_error(crossing, last, worst + crossing.radius * (1 + crossing.branch_slope)));
  arc.proven = std::isfinite(arc.error);
  return arc;
}

}  // namespace eliminant::bridge
