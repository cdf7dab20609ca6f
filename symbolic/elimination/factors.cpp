// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/factors.hpp>

#include <eliminant/base/error.hpp>

#include <flint/fmpq_mpoly_factor.h>

namespace eliminant::symbolic {

namespace {

class Factorization {
 public:
  explicit Factorization(const fmpq_mpoly_ctx_struct* ring) : ring_(ring) { fmpq_mpoly_factor_init(value_, ring_); }
  Factorization(const Factorization&) = delete;
  Factorization& operator=(const Factorization&) = delete;
  ~Factorization() { fmpq_mpoly_factor_clear(value_, ring_); }
  fmpq_mpoly_factor_struct* get() { return value_; }

  /// The bases, primitive, without constants.
  std::vector<Polynomial> factors(std::size_t variable_count) const {
    std::vector<Polynomial> result;
    for (slong i = 0; i < fmpq_mpoly_factor_length(value_, ring_); ++i) {
      Polynomial factor(variable_count);
      fmpq_mpoly_factor_get_base(factor.get(), value_, i, ring_);
      if (!factor.is_constant()) result.push_back(factor.primitive_part());
    }
    return result;
  }

 private:
  const fmpq_mpoly_ctx_struct* ring_;
  fmpq_mpoly_factor_t value_;
};

}  // namespace

std::vector<Polynomial> irreducible_factors(const Polynomial& p) {
  if (p.is_zero()) throw InvalidInput("the zero polynomial has no factorization");
  Factorization factorization(p.ring());
  if (fmpq_mpoly_factor(factorization.get(), p.get(), p.ring()) == 0)
    throw LimitReached("a polynomial could not be factored");
  return factorization.factors(p.variable_count());
}

Polynomial squarefree_part(const Polynomial& p) {
  if (p.is_zero()) throw InvalidInput("the zero polynomial has no squarefree part");
  Factorization factorization(p.ring());
  if (fmpq_mpoly_factor_squarefree(factorization.get(), p.get(), p.ring()) == 0)
    throw LimitReached("the squarefree part of a polynomial could not be computed");
  Polynomial product = Polynomial::constant(p.variable_count(), 1);
  for (const Polynomial& factor : factorization.factors(p.variable_count())) product = product * factor;
  return product;
}

std::vector<UnivariatePolynomial> irreducible_factors(const UnivariatePolynomial& p) {
  if (p.is_zero()) throw InvalidInput("the zero polynomial has no factorization");
  fmpz_poly_factor_t factorization;
  fmpz_poly_factor_init(factorization);
  fmpz_poly_factor(factorization, p.get());
  std::vector<UnivariatePolynomial> factors;
  for (slong i = 0; i < factorization->num; ++i) factors.emplace_back(factorization->p + i);
  fmpz_poly_factor_clear(factorization);
  return factors;
}

}  // namespace eliminant::symbolic
