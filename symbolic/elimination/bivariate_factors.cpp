// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/bivariate_factors.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

#include <flint/fmpq_mpoly_factor.h>

namespace eliminant::symbolic {

namespace {

/// The gcd of the coefficients of p as a polynomial in the other variable.
UnivariatePolynomial content_in(const Polynomial& p, std::size_t index) {
  UnivariatePolynomial content;
  for (const UnivariatePolynomial& coefficient : hide_variable(p, index).coefficients)
    content = gcd(content, coefficient);
  return content;
}

Polynomial in_plane(const UnivariatePolynomial& f, std::size_t index) {
  std::vector<Polynomial::Term> terms;
  for (long k = 0; k <= f.degree(); ++k) {
    std::vector<unsigned long> exponents(2, 0);
    exponents[index] = static_cast<unsigned long>(k);
    terms.push_back({Rational(f.coefficient(k)), std::move(exponents)});
  }
  return Polynomial::from_terms(2, terms).primitive_part();
}

void add_univariate_factors(std::vector<BivariateFactor>& result, const UnivariatePolynomial& f, std::size_t index) {
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, f.get());
  for (slong i = 0; i < factors->num; ++i)
    result.push_back(
        {in_plane(UnivariatePolynomial(factors->p + i), index), static_cast<unsigned long>(factors->exp[i])});
  fmpz_poly_factor_clear(factors);
}

/// Whether the images modulo primes on lines prove a polynomial without content in either variable irreducible.
bool is_irreducible_by_degrees(const Polynomial& p, std::uint64_t seed) {
  const std::size_t hidden = p.degree(0) < p.degree(1) ? 1 : 0;
  const HiddenVariablePolynomial f = hide_variable(p, hidden);
  const auto degree = static_cast<std::size_t>(f.degree());
  // Whether a factor of this degree is possible: a sum of degrees of factors modulo every prime.
  std::vector<bool> possible(degree + 1, true);
  bool irreducible = false;
  PrimeSequence primes(mix(seed, 7));
  constexpr std::uint64_t most_trials = 24;
  for (std::uint64_t trial = 0; trial < most_trials && !irreducible; ++trial) {
    const PrimeField field(primes.next());
    const mp_limb_t h = mix(seed, trial) % field.prime();
    ModularPolynomial value(field);
    ModularPolynomial coefficient(field);
    for (std::size_t k = 0; k <= degree; ++k) {
      fmpz_poly_get_nmod_poly(coefficient.get(), f.coefficients[k].get());
      nmod_poly_set_coeff_ui(value.get(), static_cast<slong>(k), nmod_poly_evaluate_nmod(coefficient.get(), h));
    }
    if (value.degree() < f.degree() || nmod_poly_is_squarefree(value.get()) == 0) continue;
    nmod_poly_factor_t factors;
    nmod_poly_factor_init(factors);
    nmod_poly_factor(factors, value.get());
    std::vector<bool> sums(degree + 1, false);
    sums[0] = true;
    for (slong i = 0; i < factors->num; ++i) {
      const auto of_factor = static_cast<std::size_t>(nmod_poly_degree(factors->p + i));
      for (std::size_t k = degree; k >= of_factor; --k)
        if (sums[k - of_factor]) sums[k] = true;
    }
    nmod_poly_factor_clear(factors);
    irreducible = true;
    for (std::size_t k = 1; k < degree; ++k) {
      possible[k] = possible[k] && sums[k];
      if (possible[k]) irreducible = false;
    }
  }
  return irreducible;
}

void add_factors(std::vector<BivariateFactor>& result, const Polynomial& p) {
  fmpq_mpoly_factor_t factors;
  fmpq_mpoly_factor_init(factors, p.ring());
  const int done = fmpq_mpoly_factor(factors, p.get(), p.ring());
  for (slong i = 0; done != 0 && i < fmpq_mpoly_factor_length(factors, p.ring()); ++i) {
    Polynomial factor(2);
    fmpq_mpoly_factor_get_base(factor.get(), factors, i, p.ring());
    if (factor.is_constant()) continue;
    result.push_back(
        {factor.primitive_part(), static_cast<unsigned long>(fmpq_mpoly_factor_get_exp_si(factors, i, p.ring()))});
  }
  fmpq_mpoly_factor_clear(factors, p.ring());
  if (done == 0) throw LimitReached("a polynomial in two variables could not be factored");
}

}  // namespace

std::vector<BivariateFactor> bivariate_factors(const Polynomial& p, std::uint64_t seed) {
  if (p.variable_count() != 2 || p.is_zero())
    throw InvalidInput("the factors of the zero polynomial, or of one not in two variables, were asked for",
                       "a polynomial in two variables that is not zero");
  std::vector<BivariateFactor> result;
  Polynomial rest = p.primitive_part();
  for (const std::size_t index : {0UL, 1UL}) {
    const UnivariatePolynomial content = content_in(rest, index);
    if (content.degree() < 1) continue;
    add_univariate_factors(result, content, index);
    rest = exact_quotient(rest, in_plane(content, index)).primitive_part();
  }
  if (rest.is_constant()) return result;
  if (is_irreducible_by_degrees(rest, seed))
    result.push_back({rest, 1});
  else
    add_factors(result, rest);
  return result;
}

}  // namespace eliminant::symbolic
