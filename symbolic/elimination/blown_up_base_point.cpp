// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/blown_up_base_point.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::symbolic {

namespace {

unsigned long total_degree(const Polynomial::Term& term) { return term.exponents[0] + term.exponents[1]; }

/// Of the terms; of the zero polynomial none.
std::optional<unsigned long> least_degree(const Polynomial& p) {
  std::optional<unsigned long> least;
  for (const Polynomial::Term& term : p.terms())
    least = std::min(least.value_or(total_degree(term)), total_degree(term));
  return least;
}

/// Whether the terms of that degree, as a form, have a real zero other than the origin.
bool has_real_zero(const Polynomial& p, unsigned long degree) {
  UnivariatePolynomial form;
  for (const Polynomial::Term& term : p.primitive_part().terms())
    if (total_degree(term) == degree)
      fmpz_poly_set_coeff_fmpz(form.get(), static_cast<slong>(term.exponents[1]), term.coefficient.numerator().get());
  return form.degree() < static_cast<long>(degree) || has_real_root(form);
}

/// With the other parameter as the kept one times m, divided by that power of the kept one.
Polynomial blown_up(const Polynomial& p, std::size_t kept, unsigned long power) {
  std::vector<Polynomial::Term> terms = p.terms();
  for (Polynomial::Term& term : terms) term.exponents[kept] = total_degree(term) - power;
  return Polynomial::from_terms(2, terms);
}

}  // namespace

std::optional<std::array<RationalSurface, 2>> blown_up_at_origin(const RationalSurface& surface) {
  const std::vector<Polynomial>& coordinates = surface.coordinates();
  const std::optional<unsigned long> degree = least_degree(coordinates[3]);
  if (!degree || *degree == 0 || has_real_zero(coordinates[3], *degree)) return std::nullopt;
  if (std::any_of(coordinates.begin(), coordinates.end(),
                  [&](const Polynomial& p) { return least_degree(p).value_or(*degree) < *degree; }))
    return std::nullopt;
  const auto chart = [&](std::size_t kept) {
    std::vector<Polynomial> result;
    for (const Polynomial& p : coordinates) result.push_back(blown_up(p, kept, *degree));
    return RationalSurface(RationalSurface::Kind::tensor_product, std::move(result));
  };
  return std::array<RationalSurface, 2>{chart(0), chart(1)};
}

}  // namespace eliminant::symbolic
