// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/infinite_base_points.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>
#include <eliminant/symbolic/elimination/linear_relations.hpp>

namespace eliminant::symbolic {

namespace {

/// The weight is the parameter times a linear form of the coordinates.
bool is_inverse_of_linear_form(const RationalSurface& surface, std::size_t parameter) {
  std::vector<Polynomial> products{surface.coordinates()[3]};
  for (const Polynomial& coordinate : surface.coordinates())
    products.push_back(coordinate * Polynomial::variable(2, parameter));
  const auto relations = linear_relations(products);
  return std::any_of(relations.begin(), relations.end(),
                     [](const auto& relation) { return !Rational(relation.front()).is_zero(); });
}

/// The terms of highest degree of a form in (1/u, 1/v), by the exponents of u and v up to `top`; as a polynomial in
/// the quotient of both, with its degree as a form.
struct HighestForm {
  UnivariatePolynomial polynomial;
  long degree = 0;
};

HighestForm highest_form(const Polynomial& p, const std::vector<unsigned long>& top) {
  HighestForm form;
  const auto terms = p.terms();
  const auto degree_of = [&](const Polynomial::Term& term) {
    return static_cast<long>(top[0] - term.exponents[0] + top[1] - term.exponents[1]);
  };
  for (const auto& term : terms) form.degree = std::max(form.degree, degree_of(term));
  for (const auto& term : terms)
    if (degree_of(term) == form.degree)
      fmpz_poly_set_coeff_fmpz(form.polynomial.get(), static_cast<slong>(top[0] - term.exponents[0]),
                               term.coefficient.numerator().get());
  return form;
}

/// A polynomial map in the inverses of both parameters whose coordinates grow in every direction.
bool grows_in_every_direction(const RationalSurface& surface) {
  const auto weight = surface.coordinates()[3].terms();
  if (weight.size() != 1) return false;
  const std::vector<unsigned long>& top = weight.front().exponents;
  if (top[0] == 0 || top[1] == 0) return false;
  UnivariatePolynomial common;
  bool vanish_at_infinity = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Polynomial& p = surface.coordinates()[k];
    if (p.degree(0) > static_cast<long>(top[0]) || p.degree(1) > static_cast<long>(top[1])) return false;
    const HighestForm form = highest_form(p, top);
    // A constant coordinate says nothing.
    if (form.degree == 0) continue;
    common = gcd(common, form.polynomial);
    if (form.polynomial.degree() == form.degree) vanish_at_infinity = false;
  }
  return !common.is_zero() && !vanish_at_infinity && !has_real_root(common);
}

}  // namespace

bool is_infinite_around_origin(const RationalSurface& surface) {
  return is_inverse_of_linear_form(surface, 0) || is_inverse_of_linear_form(surface, 1) ||
         grows_in_every_direction(surface);
}

}  // namespace eliminant::symbolic
