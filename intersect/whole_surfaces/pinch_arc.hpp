// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/whole_surfaces/branch_tube.hpp>

namespace eliminant::intersect {

/// The end of a double curve at a pinch point.
struct PinchArc {
  /// Pairs of parameters in charts, behind the point given, without the pinch point.
  std::vector<PointEnclosure> points;
  /// Bounds the distance in space of the polyline from the curve, to the pinch point.
  double error = 0;
};

/// From a pair of parameters of one point of the surface, exactly or nearly, to the pinch point `pinch`, in the charts
/// of the latter's parameters. It is proven that all double points around both belong to one arc; nullopt where
/// that fails. `surface` of tensor-product kind.
std::optional<PinchArc> trace_pinch_arc(const symbolic::RationalSurface& surface, const PointEnclosure& from,
                                        const std::array<bool, 2>& inverted, const std::array<DoubleInterval, 2>& pinch,
                                        double tolerance, const Context& context);

}  // namespace eliminant::intersect
