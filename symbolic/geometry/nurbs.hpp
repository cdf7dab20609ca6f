// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::symbolic {

/// The knots u_0 <= ... <= u_(n+p+1) of a B-spline of degree p with control points P_0, ..., P_n. They need not be
/// clamped: the curve is defined on [u_p, u_(n+1)].
struct KnotVector {
  std::size_t degree = 1;
  std::vector<Rational> knots;
};

/// The control points of one Bezier piece of a B-spline.
struct BezierSpan {
  Interval span;
  std::vector<ControlPoint> points;
};

/// Throws InvalidInput unless the knots are as many as control points + degree + 1, in order, none more often than
/// degree + 1 times, with a domain that is no point, and the degree is at least 1.
void require_knots(const KnotVector& knots, std::size_t control_points);

/// The B-spline of these points cut at its knots: for every non-empty span [a, b] inside the domain the Bezier control
/// points f(a, ..., a, b, ..., b) of its polar form f. The points may have any number of coordinates, all the same.
/// Throws as require_knots. Source: [Ramshaw1989].
std::vector<BezierSpan> bezier_spans(const KnotVector& knots, const std::vector<ControlPoint>& points);

/// A NURBS curve as its polynomial pieces, all in its own parameter, each on its span.
/// Throws as require_knots and bezier_curve; also when a single piece is zero throughout.
ParametricCurve nurbs_curve(const KnotVector& knots, const std::vector<ControlPoint>& points);

/// A NURBS surface as its pieces, ordered by the span of the first parameter, then of the second; `rows` holds a row of
/// control points for each index of the first parameter.
/// Throws as require_knots and bezier_patch; also when a single piece is zero throughout.
ParametricSurface nurbs_surface(const std::array<KnotVector, 2>& knots,
                                const std::vector<std::vector<ControlPoint>>& rows);

}  // namespace eliminant::symbolic
