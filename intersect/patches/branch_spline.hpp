// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// A cubic B-spline in (u, v, s, t, x, y, z), twice continuously differentiable, that begins and ends where the
/// polyline of `component` does; of a loop first and last control point are equal and the tangent there is one. Its
/// parameter is about the length of the polyline, coordinates and parameters counted relative to their ranges.
///
/// Knots are added where the polyline asks for them until the spline is within `tolerance` (a distance in space) of the
/// polyline, and as near, relative to their ranges, in the parameters; or until more knots do not help, because what
/// remains is the distance of the polyline's chords from its curve. A parameter that some point does not have (NaN, or
/// infinite) is NaN in all control points.
///
/// `error` is proven: that of the component plus a bound of the largest distance in space between spline and polyline
/// at equal parameters, found between each two points of the polyline from the control points of the difference, in
/// interval arithmetic. It bounds the distance both ways, because equal parameters run through both. The parameters
/// carry no bound.
///
/// Nothing for components that are no curves, and for those with a point at infinity.
/// Sources: [DeBoor1978], chapter IV (interpolation, not a knot at the ends); control points by blossoms,
/// [Ramshaw1989].
std::optional<BranchSpline> branch_spline(const SurfaceComponent& component, double tolerance);

}  // namespace eliminant::intersect
