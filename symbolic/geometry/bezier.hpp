// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// A control point with its weight multiplied in: (w x, w y, w) or (w x, w y, w z, w). A point of weight zero is the
/// zero vector, or a direction when it is meant as one.
using ControlPoint = std::vector<Rational>;

/// The coefficients, in ascending order, of the polynomial of degree n in t with these n + 1 coefficients in the
/// Bernstein basis of [lower, upper]: binomial(n, k) (upper - t)^(n-k) (t - lower)^k / (upper - lower)^n.
/// Throws InvalidInput when there are none or the interval is a point.
std::vector<Rational> power_coefficients(const std::vector<Rational>& bernstein_coefficients, const Interval& interval);

/// The inverse: the coefficients in the Bernstein basis of degree n >= that of the polynomial with these coefficients.
std::vector<Rational> bernstein_coefficients(const std::vector<Rational>& power_coefficients, const Interval& interval);

/// The Bezier curve of these control points, degree + 1 of them, as a map of the parameter that runs through `domain`
/// from the first point to the last. The degree is that of the map, which may be lower.
/// Throws InvalidInput when there are no points, all are zero, or their numbers of coordinates differ.
CurvePiece bezier_curve(const std::vector<ControlPoint>& points, const Interval& domain = {0, 1});

/// The tensor-product Bezier patch of these rows of control points, a row for each index of the first parameter.
/// Throws as bezier_curve, and InvalidInput when the rows differ in length.
SurfacePiece bezier_patch(const std::vector<std::vector<ControlPoint>>& rows,
                          const std::array<Interval, 2>& domain = {Interval{0, 1}, Interval{0, 1}});

/// Number of control points of a triangular patch: (degree + 1) (degree + 2) / 2.
std::size_t triangle_point_count(std::size_t degree);

/// The triangular Bezier patch sum degree!/(i! j! k!) P_ijk s^i t^j u^k over i + j + k = degree, on s, t, u >= 0. The
/// points come in the order of decreasing i, then j: (d,0,0), (d-1,1,0), (d-1,0,1), (d-2,2,0), ...
/// Throws as bezier_curve, and InvalidInput when their number is not that of the degree.
SurfacePiece bezier_triangle(std::size_t degree, const std::vector<ControlPoint>& points);

}  // namespace eliminant::symbolic
