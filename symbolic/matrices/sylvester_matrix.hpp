// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/arithmetic/polynomial_matrix.hpp>

namespace eliminant::symbolic {

/// The Sylvester matrix S of f and g: its columns are the coefficients of f, e f, ..., e^(n-1) f, g, e g, ..., e^(m-1)
/// g in the basis 1, e, ..., e^(m+n-1), where m and n are the degrees of f and g in the eliminated variable e. Shape
/// (m+n) x (m+n) over Z[h]. Its determinant is (-1)^(mn) times the resultant in the usual sign, and the row vector (1,
/// y, ..., y^(m+n-1)) is in the left kernel of S(h) at every common zero (h, y). Throws InvalidInput when f or g is
/// zero. Source: [BuseKhalilMourrain2005], section 2.2, equation (1).
PolynomialMatrix sylvester_matrix(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g);

}  // namespace eliminant::symbolic
