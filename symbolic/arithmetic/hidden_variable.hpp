// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::symbolic {

/// A bivariate polynomial seen in Z[h][e]: a polynomial in the variable e that a resultant eliminates, with
/// coefficients in the other, hidden variable h.
struct HiddenVariablePolynomial {
  /// Coefficient of e^k at index k; the last one is not zero. Empty for the zero polynomial.
  std::vector<UnivariatePolynomial> coefficients;

  /// Degree in the eliminated variable; -1 for zero.
  long degree() const { return static_cast<long>(coefficients.size()) - 1; }
  /// Degree in the hidden variable; -1 for zero.
  long hidden_degree() const;
  /// Total degree in both variables; -1 for zero.
  long total_degree() const;
  /// Leading coefficient in the eliminated variable; zero for zero.
  UnivariatePolynomial leading_coefficient() const;
};

/// p times the least common denominator of its coefficients, with the variable of index `hidden` (0 or 1) hidden.
/// Throws InvalidInput unless p has two variables.
HiddenVariablePolynomial hide_variable(const Polynomial& p, std::size_t hidden);

}  // namespace eliminant::symbolic
