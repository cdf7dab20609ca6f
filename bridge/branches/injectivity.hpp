// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// A rectangle of the parameters of a patch.
struct ParameterRectangle {
  std::array<double, 2> lower{};
  std::array<double, 2> upper{};
};

/// Whether different parameters in the rectangle are proven to have different points: along the tangent plane at its
/// middle the derivative stays near the identity, in the maximum norm, so that the mean value theorem tells them apart.
/// False decides nothing.
bool is_injective_on(const ControlNet& net, const ParameterRectangle& rectangle);

/// A part of a surface of several pieces: parameters of the surface are those of the net divided by `scale`, moved.
struct NetOnRectangle {
  const ControlNet& net;
  ParameterRectangle rectangle;
  std::array<double, 2> scale{1, 1};
};

/// The same of a convex set of parameters that is made up of these parts, where they meet continuously: there may be
/// kinks between them. All nets have one origin.
bool is_injective_on(const std::vector<NetOnRectangle>& parts);

}  // namespace eliminant::bridge
