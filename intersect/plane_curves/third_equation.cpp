// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/plane_curves/third_equation.hpp>

#include <algorithm>
#include <map>
#include <optional>

#include <eliminant/intersect/plane_curves/parameter_roots.hpp>
#include <eliminant/symbolic/elimination/univariate_representation.hpp>
#include <eliminant/symbolic/elimination/vanishing_factors.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::Polynomial;
using symbolic::UnivariatePolynomial;

symbolic::UnivariateRepresentation representation_of(const PlaneCurvesProblem& problem, std::uint64_t seed,
                                                     const Context& context) {
  for (long shear = 0;; shear = shear > 0 ? -shear : 1 - shear) {
    if (!symbolic::is_admissible_shear(problem.p, problem.q, shear)) continue;
    if (auto representation = symbolic::univariate_representation(problem.p.primitive_part(),
                                                                  problem.q.primitive_part(), shear, seed, context))
      return *std::move(representation);
  }
}

}  // namespace

ComplexBall evaluate(const Polynomial& p, const ComplexBall& x, const ComplexBall& y, long precision_bits) {
  ComplexBall sum;
  ComplexBall product;
  ComplexBall power;
  for (const Polynomial::Term& term : p.terms()) {
    acb_pow_ui(product.get(), x.get(), term.exponents[0], precision_bits);
    acb_pow_ui(power.get(), y.get(), term.exponents[1], precision_bits);
    acb_mul(product.get(), product.get(), power.get(), precision_bits);
    arb_set_fmpq(power.real(), term.coefficient.get(), precision_bits);
    arb_zero(power.imaginary());
    acb_addmul(sum.get(), product.get(), power.get(), precision_bits);
  }
  return sum;
}

KeptSolutions solutions_of_third(const PlaneCurvesProblem& problem, const Polynomial& third,
                                 const std::vector<Solution>& solutions, std::uint64_t seed, const Context& context) {
  KeptSolutions kept;
  std::optional<symbolic::UnivariateRepresentation> representation;
  std::map<std::size_t, UnivariatePolynomial> vanishing;
  // Of the classes that have such solutions alone: that of the simple ones may be large.
  const auto vanishing_factor = [&](std::size_t k) -> const UnivariatePolynomial& {
    const auto known = vanishing.find(k);
    if (known != vanishing.end()) return known->second;
    symbolic::UnivariateRepresentation one = *representation;
    one.classes = {representation->classes[k]};
    return vanishing.emplace(k, symbolic::vanishing_factors(one, third).front()).first->second;
  };
  for (const Solution& s : solutions) {
    const long precision_bits = std::min(acb_rel_accuracy_bits(s.x.ball.get()), acb_rel_accuracy_bits(s.y.ball.get()));
    const long working_bits = 2 * std::clamp(precision_bits, 64L, 1L << 20) + 64;
    if (acb_contains_zero(evaluate(third, s.x.ball, s.y.ball, working_bits).get()) == 0) continue;
    if (!representation) representation = representation_of(problem, seed, context);
    // The solution belongs to the class of its multiplicity; there one of two coprime factors vanishes.
    ComplexBall t;
    acb_mul_si(t.get(), s.y.ball.get(), representation->shear, working_bits);
    acb_add(t.get(), t.get(), s.x.ball.get(), working_bits);
    for (std::size_t k = 0; k < representation->classes.size(); ++k) {
      const symbolic::SquarefreeFactor& part = representation->classes[k];
      if (part.multiplicity != s.multiplicity) continue;
      const UnivariatePolynomial& common = vanishing_factor(k);
      if (common.degree() < 1) continue;
      UnivariatePolynomial rest;
      fmpz_poly_div(rest.get(), part.factor.get(), common.get());
      if (acb_contains_zero(evaluate(common, t, working_bits).get()) == 0) continue;
      if (acb_contains_zero(evaluate(rest, t, working_bits).get()) != 0) kept.decided = false;
      kept.solutions.push_back(s);
    }
  }
  return kept;
}

}  // namespace eliminant::intersect
