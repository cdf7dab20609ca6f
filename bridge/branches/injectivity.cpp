// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/injectivity.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

namespace eliminant::bridge {

namespace {

/// From the derivatives in the middles of all parts: their mean direction, so that kinks are seen from the front, and
/// lengths of which none is more than twice as long.
std::optional<ContactFrame> common_frame(const std::vector<NetOnRectangle>& parts) {
  PatchJets::Value mean;
  mean.point.setZero();
  const double share = 1 / static_cast<double>(parts.size());
  std::array<double, 2> longest{};
  std::array<double, 2> shortest{INFINITY, INFINITY};
  for (Array4d& first : mean.first) first.setZero();
  for (const NetOnRectangle& part : parts) {
    const ParameterRectangle& r = part.rectangle;
    const PatchJets::Value middle =
        PatchJets(part.net).at(0.5 * (r.lower[0] + r.upper[0]), 0.5 * (r.lower[1] + r.upper[1]));
    mean.point += share * middle.point;
    for (std::size_t k = 0; k < 2; ++k) {
      const double length = middle.first[k].head<3>().matrix().norm();
      mean.first[k] += share / length * middle.first[k];
      longest[k] = std::max(longest[k], part.scale[k] * length);
      shortest[k] = std::min(shortest[k], part.scale[k] * length);
    }
  }
  for (std::size_t k = 0; k < 2; ++k) mean.first[k] *= 0.5 * (longest[k] + shortest[k]);
  return tangent_frame(mean);
}

bool derivative_is_near_identity(const NetOnRectangle& part, const ContactFrame& frame) {
  const ParameterRectangle& r = part.rectangle;
  const TaylorTable<DoubleInterval> table =
      taylor_on_box(part.net, frame, {{r.lower[0], r.lower[1], 0}, {r.upper[0], r.upper[1], 0}}, 0, 1);
  constexpr std::size_t weight = 3;
  const DoubleInterval& w = table.at(0, 0)[weight];
  for (std::size_t row = 0; row < 2; ++row) {
    const DoubleInterval value = table.at(0, 0)[row] / w;
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::array<DoubleInterval, 4>& slope = k == 0 ? table.at(1, 0) : table.at(0, 1);
      const DoubleInterval scale = DoubleInterval::widened(part.scale[k], part.scale[k]);
      const DoubleInterval derivative = scale * (slope[row] - value * slope[weight]) / w;
      sum += (derivative - DoubleInterval(k == row ? 1 : 0)).magnitude();
    }
    if (!(sum < 1)) return false;
  }
  return true;
}

/// Where a part is folded most: the derivative along the direction in which it is smallest is shortest. The tangent
/// plane there is the one in which the part may still be spread out, though it turns away at once.
std::optional<ContactFrame> frame_at_fold(const NetOnRectangle& part) {
  const ParameterRectangle& r = part.rectangle;
  PatchJets jets(part.net);
  std::array<double, 2> at{0.5 * (r.lower[0] + r.upper[0]), 0.5 * (r.lower[1] + r.upper[1])};
  constexpr int steps = 4;
  for (int i = 0; i < steps; ++i) {
    const PatchJets::Value here = jets.at(at[0], at[1]);
    const auto dot = [](const Array4d& a, const Array4d& b) { return (a * b).head<3>().sum(); };
    const double angle = 0.5 * std::atan2(2 * dot(here.first[0], here.first[1]),
                                          dot(here.first[0], here.first[0]) - dot(here.first[1], here.first[1])) +
                         std::acos(0.0);
    const std::array<double, 2> e{std::cos(angle), std::sin(angle)};
    const Array4d slope = here.first[0] * e[0] + here.first[1] * e[1];
    const Array4d bend = along(here.second, e[0], e[1]);
    const double step = -dot(slope, bend) / dot(bend, bend);
    for (std::size_t k = 0; k < 2; ++k) {
      at[k] += step * e[k];
      if (!(at[k] >= r.lower[k] && at[k] <= r.upper[k])) return std::nullopt;
    }
  }
  return tangent_frame(jets.slopes_at(at[0], at[1]));
}

}  // namespace

bool is_injective_on(const std::vector<NetOnRectangle>& parts) {
  const std::optional<ContactFrame> frame = common_frame(parts);
  return frame && std::all_of(parts.begin(), parts.end(),
                              [&](const NetOnRectangle& part) { return derivative_is_near_identity(part, *frame); });
}

bool is_injective_on(const ControlNet& net, const ParameterRectangle& rectangle) {
  const NetOnRectangle part{net, rectangle};
  if (is_injective_on(std::vector<NetOnRectangle>{part})) return true;
  const std::optional<ContactFrame> frame = frame_at_fold(part);
  return frame && derivative_is_near_identity(part, *frame);
}

}  // namespace eliminant::bridge
