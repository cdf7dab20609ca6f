// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
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

Polynomial projective_image(const Polynomial& p, const std::array<std::array<long, 3>, 3>& a) {
  require_bivariate(p);
  const Polynomial u = Polynomial::variable(2, 0);
  const Polynomial v = Polynomial::variable(2, 1);
  const auto degree = static_cast<std::size_t>(std::max(0L, p.total_degree()));
  std::array<std::vector<Polynomial>, 3> powers;
  for (std::size_t row = 0; row < 3; ++row) {
    const Polynomial form =
        Rational(a[row][0]) * u + Rational(a[row][1]) * v + Polynomial::constant(2, Rational(a[row][2]));
    powers[row].push_back(Polynomial::constant(2, Rational(1)));
    for (std::size_t k = 0; k < degree; ++k) powers[row].push_back(powers[row].back() * form);
  }
  Polynomial image(2);
  for (const Polynomial::Term& term : p.terms()) {
    const std::size_t i = term.exponents[0];
    const std::size_t j = term.exponents[1];
    image = image + term.coefficient * (powers[0][i] * powers[1][j] * powers[2][degree - i - j]);
  }
  return image.primitive_part();
}

}  // namespace eliminant::symbolic
