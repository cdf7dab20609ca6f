// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>

namespace eliminant::symbolic {

long HiddenVariablePolynomial::hidden_degree() const {
  long result = -1;
  for (const UnivariatePolynomial& c : coefficients) result = std::max(result, c.degree());
  return result;
}

long HiddenVariablePolynomial::total_degree() const {
  long result = -1;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    if (!coefficients[k].is_zero()) result = std::max(result, static_cast<long>(k) + coefficients[k].degree());
  return result;
}

UnivariatePolynomial HiddenVariablePolynomial::leading_coefficient() const {
  return coefficients.empty() ? UnivariatePolynomial() : coefficients.back();
}

HiddenVariablePolynomial hide_variable(const Polynomial& p, std::size_t hidden) {
  if (p.variable_count() != 2 || hidden > 1)
    throw InvalidInput("a polynomial in " + std::to_string(p.variable_count()) + " variables cannot be eliminated from",
                       "two variables");
  HiddenVariablePolynomial result;
  if (p.is_zero()) return result;
  const std::size_t eliminated = 1 - hidden;
  result.coefficients.resize(static_cast<std::size_t>(p.degree(eliminated)) + 1);
  const std::vector<Polynomial::Term> terms = p.terms();
  Integer denominator(1);
  for (const auto& term : terms) fmpz_lcm(denominator.get(), denominator.get(), fmpq_denref(term.coefficient.get()));
  for (const auto& term : terms) {
    const Rational scaled = Rational(denominator) * term.coefficient;
    fmpz_poly_set_coeff_fmpz(result.coefficients[term.exponents[eliminated]].get(),
                             static_cast<slong>(term.exponents[hidden]), fmpq_numref(scaled.get()));
  }
  return result;
}

}  // namespace eliminant::symbolic
