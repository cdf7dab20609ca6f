// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// An interval for each homogeneous coordinate of a point.
using PointBox = std::array<DoubleInterval, 4>;

/// True when it is proven that no parameter in [0, 1]^2 has that point, whatever the signs of the weights: by
/// subdivision, until a minor of both coordinate vectors has one sign on every part. False when that does not come
/// soon. The point is relative to the origin of the net.
bool excludes_point(const ControlNet& patch, const PointBox& point, const Context& context);

}  // namespace eliminant::bridge
