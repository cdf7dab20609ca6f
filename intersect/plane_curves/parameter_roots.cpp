// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/plane_curves/parameter_roots.hpp>

#include <eliminant/base/error.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::UnivariatePolynomial;

/// Beyond this no input within the size limits is still undecided; it only bounds what a mistake could cost.
constexpr long precision_ceiling = 1L << 24;

}  // namespace

ComplexBall evaluate(const UnivariatePolynomial& p, const ComplexBall& at, long precision_bits) {
  ComplexBall value;
  for (long i = p.degree(); i >= 0; --i) {
    acb_mul(value.get(), value.get(), at.get(), precision_bits);
    acb_add_fmpz(value.get(), value.get(), p.coefficient(i).get(), precision_bits);
  }
  return value;
}

ParameterRoots::ParameterRoots(const UnivariatePolynomial& f, Wanted wanted, const Context& context)
    : factors_(symbolic::squarefree_decomposition(f)), context_(context) {
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    classes_.push_back(wanted == Wanted::real ? bridge::IsolatedRoots::real(factors_[k].factor, context)
                                              : bridge::IsolatedRoots(factors_[k].factor, context));
    for (std::size_t i = 0; i < classes_.back().balls().size(); ++i) roots_.push_back({k, i});
  }
}

unsigned long ParameterRoots::distinct() const {
  unsigned long result = 0;
  for (const symbolic::SquarefreeFactor& part : factors_) result += static_cast<unsigned long>(part.factor.degree());
  return result;
}

void ParameterRoots::refine(std::size_t i, long relative_bits) {
  classes_[roots_[i].factor].refine(roots_[i].index, relative_bits, context_);
}

bool ParameterRoots::is_zero_of(std::size_t i, const UnivariatePolynomial& g) {
  if (g.is_zero()) return true;
  const UnivariatePolynomial common = symbolic::gcd(factor(i), g);
  if (common.degree() < 1) return false;
  UnivariatePolynomial rest;
  fmpz_poly_div(rest.get(), factor(i).get(), common.get());
  // The factor is squarefree: exactly one of the two vanishes.
  for (long bits = 64; bits <= precision_ceiling; bits *= 2) {
    if (acb_contains_zero(evaluate(rest, ball(i), bits + 64).get()) == 0) return true;
    if (acb_contains_zero(evaluate(common, ball(i), bits + 64).get()) == 0) return false;
    refine(i, bits);
  }
  throw PrecisionExhausted("a parameter could not be compared with the root of another polynomial");
}

int ParameterRoots::compare(std::size_t i, const symbolic::Rational& value) {
  UnivariatePolynomial linear;
  fmpz_poly_set_coeff_fmpz(linear.get(), 1, fmpq_denref(value.get()));
  fmpz_poly_set_coeff_fmpz(linear.get(), 0, (-value.numerator()).get());
  if (arb_contains_fmpq(ball(i).real(), value.get()) != 0 && is_zero_of(i, linear)) return 0;
  for (long bits = 64; bits <= precision_ceiling; bits *= 2) {
    if (arb_contains_fmpq(ball(i).real(), value.get()) == 0) {
      bridge::RealBall difference(value, bits + 64);
      arb_sub(difference.get(), ball(i).real(), difference.get(), bits + 64);
      if (arb_is_positive(difference.get()) != 0) return 1;
      if (arb_is_negative(difference.get()) != 0) return -1;
    }
    refine(i, bits);
  }
  throw PrecisionExhausted("a parameter could not be compared with a rational number");
}

}  // namespace eliminant::intersect
