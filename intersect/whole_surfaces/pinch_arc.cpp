// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/pinch_arc.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/bridge/branches/zoomed_tracing.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/intersect/whole_surfaces/projection_charts.hpp>

namespace eliminant::intersect {

namespace {

/// The double points in this part of the rectangle around the pinch point are those that are proven to be one arc.
const bridge::ParameterRectangle inner{{0.125, 0.125}, {0.875, 0.875}};

}  // namespace

std::optional<PinchArc> trace_pinch_arc(const symbolic::RationalSurface& surface, const PointEnclosure& from,
                                        const std::array<bool, 2>& inverted, const std::array<DoubleInterval, 2>& pinch,
                                        double tolerance, const Context& context) {
  const Charts charts{inverted[0], inverted[1], inverted[0], inverted[1]};
  const ParameterBox start = in_charts(from.box, from.inverted, charts);
  const std::array<double, 2> centre{middle(pinch[0]), middle(pinch[1])};
  double reach = 0;
  for (std::size_t k = 0; k < 4; ++k) reach = std::max(reach, std::fabs(middle(start[k]) - centre[k % 2]));
  if (!(reach > 0) || !std::isfinite(reach)) return std::nullopt;

  // Both preimages well inside the rectangle, whose sides are of few digits.
  const double half = std::exp2(std::ceil(std::log2(4 * reach)));
  std::array<double, 2> lower{};
  symbolic::ParameterRegion region;
  for (std::size_t k = 0; k < 2; ++k) {
    lower[k] = half * (std::round(16 * centre[k] / half) / 16 - 1);
    region.sides[k] = {bridge::exactly(lower[k]), bridge::exactly(lower[k] + 2 * half)};
  }
  const auto exact =
      prepared_net({change_parameters(surface, {chart(inverted[0]), chart(inverted[1])}), std::move(region)});
  if (!exact) return std::nullopt;
  const std::array<symbolic::Rational, 3> origin = exact->origin();
  const auto net = exact->rounded(origin);
  if (!net) return std::nullopt;
  for (const Eigen::Array4d& point : net->points)
    if (!(point[3] > net->error[3])) return std::nullopt;
  const auto proven = bridge::pinch_point_in(*net, inner);
  if (!proven) return std::nullopt;

  const auto to_net = [&](double value, std::size_t k) { return (value - lower[k % 2]) / (2 * half); };
  std::array<double, 4> at{};
  for (std::size_t k = 0; k < 4; ++k) at[k] = to_net(middle(start[k]), k);
  const bridge::TracedArc arc = bridge::trace_to_pinch_point({*net, *net, exact->exact, exact->exact, origin}, at,
                                                             *proven, inner, tolerance, context);
  if (!arc.proven || arc.points.size() < 2) return std::nullopt;
  PinchArc result;
  result.error = arc.error;
  for (std::size_t i = 1; i + 1 < arc.points.size(); ++i) {
    PointEnclosure point{charts, {}};
    for (std::size_t k = 0; k < 4; ++k)
      point.box[k] =
          DoubleInterval(lower[k % 2]) + DoubleInterval(2 * half) * DoubleInterval(arc.points[i].parameters[k]);
    result.points.push_back(point);
  }
  return result;
}

}  // namespace eliminant::intersect
