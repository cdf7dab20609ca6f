// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/bridge/control_net.hpp>
#include <eliminant/bridge/injectivity.hpp>

namespace eliminant::bridge {

/// A pair of parameters (u, v, s, t) of one patch.
using ParameterPair = std::array<double, 4>;

/// The double points of a patch in a rectangle around a pinch point (Whitney umbrella), proven: the pairs x, x + k d
/// with one direction d and one x for each k, an arc that the exchange of both parameters maps to itself.
struct PinchPoint {
  std::array<double, 2> parameters{};
  /// Bounds the error of both.
  double radius = 0;
  /// How fast x and d change with k at most, in the maximum norm, and how fast the patch moves with its parameters.
  double speed = 0;
  double space_speed = 0;
};

/// The pinch point in the rectangle, and that all double points there belong to its arc; nullopt where that is not
/// proven.
///
/// With d = e + m f, e near the direction in which the derivative vanishes, (Phi(x + k d) - Phi(x)) / k is smooth, also
/// at k = 0. Where its derivative by x and m is near one regular matrix for all pairs in the rectangle there is at most
/// one zero for each k; pairs in other directions have different points because the derivative along f does not vanish.
std::optional<PinchPoint> pinch_point_in(const ControlNet& net, const ParameterRectangle& rectangle);

/// Pairs along the arc from a pair on it to the pinch point, without the former; `count` steps of equal length in k.
std::vector<ParameterPair> arc_to_pinch_point(const ControlNet& net, const PinchPoint& pinch, const ParameterPair& from,
                                              std::size_t count);

}  // namespace eliminant::bridge
