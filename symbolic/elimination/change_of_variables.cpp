// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>

namespace eliminant::symbolic {

namespace {

void require_bivariate(const Polynomial& p) {
  if (p.variable_count() != 2)
    throw InvalidInput("a plane change of variables was applied to a polynomial in " +
                           std::to_string(p.variable_count()) + " variables",
                       "two variables");
}

}  // namespace

Polynomial shear(const Polynomial& p, const Rational& s) {
  require_bivariate(p);
  if (s.is_zero()) return p;
  const Polynomial y = Polynomial::variable(2, 1);
  const std::array<Polynomial, 2> images{Polynomial::variable(2, 0) - s * y, y};
  return p.compose(images);
}

Polynomial scale_by_powers_of_two(const Polynomial& p, long a, long b) {
  require_bivariate(p);
  std::vector<Polynomial::Term> terms = p.terms();
  for (auto& term : terms) {
    const long exponent = a * static_cast<long>(term.exponents[0]) + b * static_cast<long>(term.exponents[1]);
    if (exponent >= 0)
      fmpq_mul_2exp(term.coefficient.get(), term.coefficient.get(), static_cast<flint_bitcnt_t>(exponent));
    else
      fmpq_div_2exp(term.coefficient.get(), term.coefficient.get(), static_cast<flint_bitcnt_t>(-exponent));
  }
  return Polynomial::from_terms(2, terms);
}

Polynomial exchange_variables(const Polynomial& p) {
  require_bivariate(p);
  std::vector<Polynomial::Term> terms = p.terms();
  for (auto& term : terms) std::swap(term.exponents[0], term.exponents[1]);
  return Polynomial::from_terms(2, terms);
}

}  // namespace eliminant::symbolic
