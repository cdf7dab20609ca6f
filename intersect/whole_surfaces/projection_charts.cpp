// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/projection_charts.hpp>

#include <algorithm>

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::intersect {

using symbolic::Polynomial;

DoubleInterval ProjectiveChange::operator()(const DoubleInterval& y) const {
  const auto number = [](long value) { return DoubleInterval(static_cast<double>(value)); };
  if (c != 0 && !(number(c) * y + number(d)).excludes_zero()) return {-INFINITY, INFINITY};
  const auto at = [&](double end) { return (number(a) * end + number(b)) / (number(c) * end + number(d)); };
  return hull(at(y.lower), at(y.upper));
}

Polynomial change_parameters(const Polynomial& p, const std::array<long, 2>& degrees,
                             const std::array<ProjectiveChange, 2>& changes) {
  std::array<std::vector<Polynomial>, 2> images;
  for (std::size_t k = 0; k < 2; ++k) {
    const Polynomial y = Polynomial::variable(2, k);
    const ProjectiveChange& change = changes[k];
    const Polynomial above = symbolic::Rational(change.a) * y + Polynomial::constant(2, change.b);
    const Polynomial below = symbolic::Rational(change.c) * y + Polynomial::constant(2, change.d);
    for (long e = 0; e <= degrees[k]; ++e)
      images[k].push_back(power(above, static_cast<unsigned long>(e)) *
                          power(below, static_cast<unsigned long>(degrees[k] - e)));
  }
  Polynomial result(2);
  for (const auto& term : p.terms())
    result = result + term.coefficient * (images[0][term.exponents[0]] * images[1][term.exponents[1]]);
  return result;
}

symbolic::RationalSurface change_parameters(const symbolic::RationalSurface& surface,
                                            const std::array<ProjectiveChange, 2>& changes) {
  std::vector<Polynomial> coordinates;
  for (const Polynomial& p : surface.coordinates())
    coordinates.push_back(change_parameters(p, surface.bidegree(), changes));
  return {surface.kind(), std::move(coordinates)};
}

symbolic::RationalSurface exchange_parameters(const symbolic::RationalSurface& surface) {
  std::vector<Polynomial> coordinates;
  for (const Polynomial& p : surface.coordinates()) coordinates.push_back(symbolic::exchange_variables(p));
  return {surface.kind(), std::move(coordinates)};
}

bool is_polynomial(const symbolic::RationalSurface& surface) { return surface.coordinates()[3].is_constant(); }

bool is_general_at_infinity(const Polynomial& curve) {
  for (std::size_t k = 0; k < 2; ++k) {
    const symbolic::UnivariatePolynomial leading = symbolic::hide_variable(curve, 1 - k).leading_coefficient();
    if (leading.degree() < curve.degree(1 - k)) return false;
    if (leading.degree() < 1) continue;
    const auto parts = symbolic::squarefree_decomposition(leading);
    if (std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.multiplicity > 1; })) return false;
  }
  return true;
}

}  // namespace eliminant::intersect
