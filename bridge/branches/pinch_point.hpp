// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/bridge/branches/injectivity.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// The double points of a patch in a rectangle around a pinch point (Whitney umbrella), proven: the pairs x, x + k d
/// with one direction d and one x for each k, an arc that the exchange of both parameters maps to itself.
struct PinchPoint {
  std::array<double, 2> parameters{};
  /// Bounds the error of both.
  double radius = 0;
  /// Bounds the error along d and across it.
  std::array<double, 2> errors{};
  /// Of the direction d at the pinch point.
  double angle = 0;
};

/// The pinch point in the rectangle, and that all double points there belong to its arc; nullopt where that is not
/// proven.
///
/// With d = e + m f, e near the direction in which the derivative vanishes, (Phi(x + k d) - Phi(x)) / k is smooth, also
/// at k = 0. Where its derivative by x and m is near one regular matrix for all pairs in the rectangle, entry by entry,
/// there is at most one zero for each k; pairs in other directions have different points because the derivative along f
/// does not vanish.
std::optional<PinchPoint> pinch_point_in(const ControlNet& net, const ParameterRectangle& rectangle);

/// Whether no point of one rectangle is proven to have a different one of the other for its double: both are near a
/// pinch point that was found, and too far from its arc. On the arc x(k) leaves the pinch point x(0) by -k/2 along d,
/// nearly. False decides nothing.
bool is_off_arc(const ControlNet& net, const PinchPoint& pinch, const ParameterRectangle& first,
                const ParameterRectangle& second);

/// A bound of the distance in space between the pinch point and the double points whose parameters all differ from it
/// by at most `near`: of the square of that. nullopt where it is not proven.
std::optional<double> reach_of_pinch_point(const ControlNet& net, const PinchPoint& pinch, double near);

}  // namespace eliminant::bridge
