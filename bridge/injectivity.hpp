// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/bridge/control_net.hpp>

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

}  // namespace eliminant::bridge
