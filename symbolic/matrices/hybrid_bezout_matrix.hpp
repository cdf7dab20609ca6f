// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/arithmetic/polynomial_matrix.hpp>

namespace eliminant::symbolic {

/// The hybrid Bezout matrix of f = sum a_k e^k and g = sum b_k e^k with formal degrees m >= n in the eliminated
/// variable e. Its rows are the coefficients (of e^0, ..., e^(m-1)) of polynomials in the ideal (f, g):
///     row i < n:      (a_m e^i + ... + a_(m-i)) e^(m-n) g - (b_n e^i + ... + b_(n-i)) f,
///     row n + s:      e^s g,     0 <= s < m - n.
/// Shape m x m over Z[h]; (1, y, ..., y^(m-1)) is in its right kernel at every common zero. Unlike the Bezout matrix it
/// has no spurious factor when m > n. With formal degrees equal to the total degrees of f and g, row i has total degree
/// at most m + i and row n + s at most n + s.
/// Throws InvalidInput when m < n, n < 1, or a degree of f or g is larger than its formal degree.
/// Source: [Jouanolou1991] gives the hybrid matrices between those of Sylvester and Bezout.
PolynomialMatrix hybrid_bezout_matrix(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g, long m,
                                      long n);

}  // namespace eliminant::symbolic
