// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/fibre_gcd.hpp>

namespace eliminant::symbolic {

namespace {

/// Coefficients in F[t]/(h) of a polynomial in y, ascending; the last one is not zero.
using FibrePolynomial = std::vector<ModularPolynomial>;

void reduce(FibrePolynomial& f, const ModularPolynomial& h) {
  for (ModularPolynomial& c : f) nmod_poly_rem(c.get(), c.get(), h.get());
  while (!f.empty() && f.back().is_zero()) f.pop_back();
}

ModularPolynomial exact_quotient(const ModularPolynomial& a, const ModularPolynomial& b) {
  ModularPolynomial quotient(a);
  nmod_poly_div(quotient.get(), a.get(), b.get());
  return quotient;
}

/// f <- f mod g for monic g.
void remainder(FibrePolynomial& f, const FibrePolynomial& g, const ModularPolynomial& h) {
  ModularPolynomial product(h);
  while (f.size() >= g.size()) {
    const std::size_t shift = f.size() - g.size();
    const ModularPolynomial leading = f.back();
    for (std::size_t k = 0; k < g.size(); ++k) {
      nmod_poly_mulmod(product.get(), leading.get(), g[k].get(), h.get());
      nmod_poly_sub(f[shift + k].get(), f[shift + k].get(), product.get());
    }
    while (!f.empty() && f.back().is_zero()) f.pop_back();
  }
}

unsigned long gcd_degree(FibrePolynomial f, FibrePolynomial g, ModularPolynomial h) {
  unsigned long split_off = 0;
  for (;;) {
    reduce(f, h);
    reduce(g, h);
    if (g.empty()) std::swap(f, g);
    if (g.empty()) return split_off;  // excluded by the caller
    ModularPolynomial divisor(h), inverse(h), unused(h);
    nmod_poly_xgcd(divisor.get(), inverse.get(), unused.get(), g.back().get(), h.get());
    if (divisor.degree() > 0) {
      // The leading coefficient of g vanishes at the roots of `divisor` only: treat the two sets of roots apart.
      split_off += gcd_degree(f, g, divisor);
      h = exact_quotient(h, divisor);
      continue;
    }
    if (f.empty()) return split_off + (g.size() - 1) * static_cast<unsigned long>(h.degree());
    for (ModularPolynomial& c : g) nmod_poly_mulmod(c.get(), c.get(), inverse.get(), h.get());
    remainder(f, g, h);
    std::swap(f, g);
  }
}

FibrePolynomial reduce(const HiddenVariablePolynomial& f, const PrimeField& field) {
  FibrePolynomial result;
  for (const UnivariatePolynomial& c : f.coefficients) {
    result.emplace_back(field);
    fmpz_poly_get_nmod_poly(result.back().get(), c.get());
  }
  return result;
}

/// f vanishes identically above a root of h exactly when all its coefficients share a root with h.
bool vanishes_on_a_fibre(const FibrePolynomial& f, const ModularPolynomial& h) {
  ModularPolynomial common(h);
  for (const ModularPolynomial& c : f) nmod_poly_gcd(common.get(), common.get(), c.get());
  return common.degree() > 0;
}

}  // namespace

std::optional<unsigned long> fibre_gcd_degree_modulo(const HiddenVariablePolynomial& f,
                                                     const HiddenVariablePolynomial& g, const UnivariatePolynomial& h,
                                                     const PrimeField& field) {
  ModularPolynomial modulus(field);
  fmpz_poly_get_nmod_poly(modulus.get(), h.get());
  if (modulus.degree() < h.degree() || !nmod_poly_is_squarefree(modulus.get())) return std::nullopt;
  FibrePolynomial f_modular = reduce(f, field);
  FibrePolynomial g_modular = reduce(g, field);
  if (vanishes_on_a_fibre(f_modular, modulus) && vanishes_on_a_fibre(g_modular, modulus)) return std::nullopt;
  return gcd_degree(std::move(f_modular), std::move(g_modular), std::move(modulus));
}

}  // namespace eliminant::symbolic
