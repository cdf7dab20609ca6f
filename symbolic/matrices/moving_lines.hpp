// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::symbolic {

/// A line (or plane, or hyperplane) a_0(t) x_0 + ... + a_n(t) x_n = 0 that contains the point of parameter t of a curve
/// for every t: a syzygy of the coordinates of the curve.
using MovingLine = std::vector<UnivariatePolynomial>;

/// A basis of the moving lines (of a plane curve) or planes (of a space curve) over Z[t], n of them for n + 1
/// coordinates: their degrees add up to the degree of the curve, and at every t, infinity included, they are
/// independent, so that their common zero is the point of the curve. By increasing degree; entries are primitive.
/// Source: [SederbergChen1995]; the mu-basis.
std::vector<MovingLine> moving_line_basis(const RationalCurve& curve);

/// M(f)_nu: row i belongs to t^(nu - i), columns to a basis of the moving lines (of a space curve: planes) of degree
/// nu. For nu >= degree - 1 its rank drops exactly on the curve. For a plane curve and nu = degree - 1 it is square,
/// and its determinant is the implicit equation to the power of the degree of the map. Source: [LuuBuseMourrain2009],
/// section 2.1 and Proposition 1. Throws InvalidInput when nu is negative.
MatrixRepresentation moving_line_matrix(const RationalCurve& curve, long nu);

}  // namespace eliminant::symbolic
