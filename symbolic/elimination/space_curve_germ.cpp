// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/space_curve_germ.hpp>

#include <algorithm>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/factors.hpp>

#include <flint/fmpq_mpoly.h>

namespace eliminant::symbolic {

namespace {

Polynomial resultant(const Polynomial& f, const Polynomial& g, std::size_t index) {
  Polynomial result(f.variable_count());
  if (fmpq_mpoly_resultant(result.get(), f.get(), g.get(), static_cast<slong>(index), f.ring()) == 0)
    throw LimitReached("a resultant in three variables could not be computed");
  return result;
}

/// p on the axis, as a polynomial in x_index, divided by the powers of that.
Polynomial away_from_origin(const Polynomial& p, std::size_t index) {
  std::vector<Polynomial::Term> on_axis;
  unsigned long least = 0;
  for (Polynomial::Term& term : p.terms()) {
    const unsigned long power = term.exponents[index];
    if (std::any_of(term.exponents.begin(), term.exponents.end(),
                    [&](const unsigned long& e) { return e > 0 && &e != &term.exponents[index]; }))
      continue;
    least = on_axis.empty() ? power : std::min(least, power);
    on_axis.push_back(std::move(term));
  }
  for (Polynomial::Term& term : on_axis) term.exponents[index] -= least;
  return Polynomial::from_terms(p.variable_count(), on_axis);
}

bool is_only_common_zero_on_axis(const Polynomial& f, const Polynomial& g, std::size_t index) {
  const Polynomial f_away = away_from_origin(f, index);
  const Polynomial g_away = away_from_origin(g, index);
  if (f_away.is_zero() || g_away.is_zero()) return false;
  return !resultant(f_away, g_away, index).is_zero();
}

bool has_linear_term(const Polynomial& p) {
  const std::vector<Polynomial::Term> terms = p.terms();
  return std::any_of(terms.begin(), terms.end(), [](const Polynomial::Term& term) {
    unsigned long degree = 0;
    for (const unsigned long e : term.exponents) degree += e;
    return degree == 1;
  });
}

}  // namespace

std::optional<Polynomial> projected_curve(const Polynomial& f, const Polynomial& g, std::size_t index) {
  if (f.degree(index) != f.total_degree() || g.degree(index) != g.total_degree()) return std::nullopt;
  const Polynomial with_multiplicities = resultant(f, g, index);
  if (with_multiplicities.is_zero()) return std::nullopt;
  return squarefree_part(with_multiplicities);
}

bool is_singular_at_origin(const Polynomial& f, const Polynomial& g,
                           const std::array<std::optional<Polynomial>, 3>& projections) {
  if (!f.constant_term().is_zero() || !g.constant_term().is_zero()) return false;
  std::size_t singular = 0;
  for (std::size_t index = 0; index < 3; ++index)
    if (projections[index] && !has_linear_term(*projections[index]) && is_only_common_zero_on_axis(f, g, index))
      ++singular;
  return singular >= 2;
}

}  // namespace eliminant::symbolic
