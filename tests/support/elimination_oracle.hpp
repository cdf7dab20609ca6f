// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <support/bezier_case.hpp>

namespace eliminant::test {

/// The polynomial of degree 2 m n d in t (plane curves: m d) whose roots are the parameters at which the curve of
/// degree d meets the whole patch of bidegree (m, n) (the whole second curve, of degree m), complex parameters and
/// those outside the domains included: the resultant, in the parameters of the patch, of three planes through the point
/// (two lines). Zero for a curve on the patch, and for a patch with base points.
///
/// It shares nothing with the engines but the exact arithmetic of FLINT: determinants of Dixon's matrix of order 6 m n
/// (Sylvester's, of order 2 m) at as many integers as the degree says, interpolated ([Dixon1909]).
symbolic::UnivariatePolynomial eliminated(const BezierCase& bezier);

/// Over a graph (x, y, f(x, y)): f(c_x, c_y) - c_z for a polynomial curve c. nullopt where the patch is no graph or the
/// curve is rational.
std::optional<symbolic::UnivariatePolynomial> substituted_in_graph(const BezierCase& bezier);

/// The curve of a case as a map, and its point at a real parameter.
symbolic::RationalCurve curve_map(const BezierCase& bezier);

/// Sturm's count of the distinct roots in the open interval (0, 1).
long sturm_count_in_unit_interval(const symbolic::UnivariatePolynomial& squarefree);

/// True when it is proven that the curve at this real parameter is not on the patch over its domain (the second curve
/// over [0, 1]): the domain is cut in halves until a plane through the point leaves each part on one side.
bool proven_apart(const BezierCase& bezier, const bridge::RealBall& t);

}  // namespace eliminant::test
