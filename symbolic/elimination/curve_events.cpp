// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/curve_events.hpp>

#include <eliminant/symbolic/elimination/common_component.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::symbolic {

namespace {

Polynomial in_two_variables(const HiddenVariablePolynomial& g) {
  std::vector<Polynomial::Term> terms;
  for (std::size_t k = 0; k < g.coefficients.size(); ++k)
    for (long i = 0; i <= g.coefficients[k].degree(); ++i)
      if (const Integer c = g.coefficients[k].coefficient(i); !c.is_zero())
        terms.push_back({c, {static_cast<unsigned long>(i), k}});
  return Polynomial::from_terms(2, terms);
}

UnivariatePolynomial squarefree_part(const UnivariatePolynomial& p) {
  UnivariatePolynomial product({Integer(1)});
  for (const SquarefreeFactor& part : squarefree_decomposition(p)) product = product * part.factor;
  return product;
}

}  // namespace

ReducedCurve reduced_curve(const Polynomial& f) {
  ReducedCurve curve;
  const Polynomial with_x = split_common_component(f, f.derivative(0)).component;
  const Polynomial repeated = split_common_component(with_x, f.derivative(1)).component;
  curve.repeated_factor = !repeated.is_constant();
  HiddenVariablePolynomial g = hide_variable(exact_quotient(f, repeated).primitive_part(), 0);
  UnivariatePolynomial content;
  for (const UnivariatePolynomial& c : g.coefficients) content = gcd(content, c);
  for (UnivariatePolynomial& c : g.coefficients) fmpz_poly_div(c.get(), c.get(), content.get());
  curve.vertical_lines = content.primitive_part();
  curve.rest = in_two_variables(g).primitive_part();
  return curve;
}

UnivariatePolynomial on_vertical_line(const HiddenVariablePolynomial& g, const Rational& x) {
  fmpq_poly_t restricted;
  fmpq_poly_init(restricted);
  Rational value;
  for (std::size_t k = 0; k < g.coefficients.size(); ++k) {
    fmpz_poly_evaluate_fmpq(value.get(), g.coefficients[k].get(), x.get());
    fmpq_poly_set_coeff_fmpq(restricted, static_cast<slong>(k), value.get());
  }
  UnivariatePolynomial result;
  fmpq_poly_get_numerator(result.get(), restricted);
  fmpq_poly_clear(restricted);
  return result.primitive_part();
}

UnivariatePolynomial on_horizontal_line(const Polynomial& g, const Rational& y) {
  return on_vertical_line(hide_variable(g, 1), y);
}

UnivariatePolynomial event_polynomial(const ReducedCurve& curve, const std::vector<UnivariatePolynomial>& others,
                                      std::uint64_t seed, const Context& context) {
  UnivariatePolynomial product = curve.vertical_lines;
  const HiddenVariablePolynomial g = hide_variable(curve.rest, 0);
  if (g.degree() >= 1) product = product * g.leading_coefficient();
  if (g.degree() >= 2)
    product = product * squarefree_part(resultant(g, hide_variable(curve.rest.derivative(1), 0), seed, context));
  for (const UnivariatePolynomial& other : others)
    if (!other.is_zero()) product = product * other;
  return squarefree_part(product);
}

int sign_at(const UnivariatePolynomial& p, const Rational& x) {
  Rational value;
  fmpz_poly_evaluate_fmpq(value.get(), p.get(), x.get());
  return value.sign();
}

}  // namespace eliminant::symbolic
