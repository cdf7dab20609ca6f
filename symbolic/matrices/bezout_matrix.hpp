// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/arithmetic/polynomial_matrix.hpp>

namespace eliminant::symbolic {

/// The Bezout matrix (theta_ij) of f and g, where (f(u) g(v) - g(u) f(v)) / (u - v) = sum theta_ij u^i v^j.
/// Shape d x d over Z[h], symmetric, d the larger degree in the eliminated variable.
/// With m = deg f <= n = deg g: det B = (-1)^(n(n+1)/2) lc(g)^(n-m) det S, S the Sylvester matrix of f and g. (The
/// printed Proposition 3 has the exponent n(n-1)/2, which is wrong for odd n.) The factor lc(g)^(n-m) is spurious: its
/// roots are eigenvalues above which there need not be a solution.
/// Throws InvalidInput when f or g is zero.
/// Source: [BuseKhalilMourrain2005], Definition 2 and Proposition 3.
PolynomialMatrix bezout_matrix(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g);

}  // namespace eliminant::symbolic
