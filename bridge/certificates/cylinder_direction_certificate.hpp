// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/numeric/cylinder_through_points.hpp>

namespace eliminant::bridge {

/// A direction (x : y : z) whose coordinate of index `pivot` is 1, with exactly one direction of a cylinder in the
/// polydisc of this radius around the other two coordinates. All three have moduli of at most 1 + 2^-50.
struct CertifiedDirection {
  numeric::ComplexDirection center;
  std::size_t pivot = 0;
  double radius = 0;
  /// The direction is real; else it is not, and its conjugate is another one.
  bool real = false;
};

/// All directions of the cylinders through five points, one of each pair of conjugate ones, the real ones first.
using CertifiedDirections = numeric::AtMostSix<CertifiedDirection>;

/// The offsets of the last four points from the first, over a power of two that makes them at most 1.
struct ScaledOffsets {
  std::array<numeric::SpaceVector<DoubleInterval>, 4> offsets;
  int scale_log2 = 0;  ///< the true offsets are these times 2^scale_log2
};
ScaledOffsets scaled_offsets(const std::array<std::array<double, 3>, 5>& points);

/// The complete list of directions, proven in hardware doubles: six zeros of the conic and the cubic of
/// numeric::CylinderDirectionForms, each proven by the Krawczyk test in the chart of its largest coordinate, and
/// pairwise distinct. As their number is the product of the degrees, all are simple and none is missing. The points
/// are exact. nullopt: nothing was proven, as where directions are multiple or nearly so, or the points nearly
/// coplanar.
///
/// Rounding: coefficients are intervals; evaluation at |x|, |y|, |z| <= 1 + 2^-50 has at most 32 rounded operations
/// behind each term, so that a value differs from the true one by at most 2^-46 times the sum of the absolute
/// coefficients, times the degree for a partial derivative.
std::optional<CertifiedDirections> certify_cylinder_directions(const ScaledOffsets& points);

/// Enclosures of c and c.c, c the vector from the first point to the foot of the perpendicular from it to the axis of
/// a real direction, in the scale of the offsets; infinite where the direction is enclosed too coarsely.
struct EnclosedAxis {
  numeric::SpaceVector<DoubleInterval> direction;  ///< with `pivot` coordinate 1
  numeric::SpaceVector<DoubleInterval> offset;
  DoubleInterval radius_squared;
};
EnclosedAxis enclose_axis(const ScaledOffsets& points, const CertifiedDirection& direction);

}  // namespace eliminant::bridge
