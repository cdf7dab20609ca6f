// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>

namespace eliminant::symbolic {

namespace {

/// Sum over the coefficients c_k(h) of (1-norm of c_k)^2: by Cauchy's and Hadamard's inequalities on |h| = 1 its powers
/// bound the coefficients of the Sylvester determinant.
Integer squared_row_norm(const HiddenVariablePolynomial& f) {
  Integer sum;
  for (const UnivariatePolynomial& c : f.coefficients) {
    Integer norm;
    Integer magnitude;
    for (long k = 0; k <= c.degree(); ++k) {
      fmpz_abs(magnitude.get(), c.coefficient(k).get());
      norm = norm + magnitude;
    }
    sum = sum + norm * norm;
  }
  return sum;
}

std::vector<ModularPolynomial> reduce(const HiddenVariablePolynomial& f, const PrimeField& field) {
  std::vector<ModularPolynomial> result;
  for (const UnivariatePolynomial& c : f.coefficients) {
    result.emplace_back(field);
    fmpz_poly_get_nmod_poly(result.back().get(), c.get());
  }
  return result;
}

void evaluate(const std::vector<ModularPolynomial>& coefficients, mp_limb_t h, ModularPolynomial& value) {
  nmod_poly_zero(value.get());
  for (std::size_t k = coefficients.size(); k-- > 0;)
    nmod_poly_set_coeff_ui(value.get(), static_cast<slong>(k), nmod_poly_evaluate_nmod(coefficients[k].get(), h));
}

}  // namespace

std::optional<ModularPolynomial> resultant_modulo(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g,
                                                  const PrimeField& field) {
  if (f.degree() < 0 || g.degree() < 0)
    throw InvalidInput("the resultant of a zero polynomial was asked for", "two non-zero polynomials");
  const std::vector<ModularPolynomial> f_modular = reduce(f, field);
  const std::vector<ModularPolynomial> g_modular = reduce(g, field);
  if (f_modular.back().is_zero()) return std::nullopt;
  const long degree_bound =
      std::min(f.hidden_degree() * g.degree() + g.hidden_degree() * f.degree(), f.total_degree() * g.total_degree());
  std::vector<mp_limb_t> points;
  std::vector<mp_limb_t> values;
  ModularPolynomial f_at(field);
  ModularPolynomial g_at(field);
  for (mp_limb_t h = 0; static_cast<long>(points.size()) <= degree_bound; ++h) {
    evaluate(f_modular, h, f_at);
    if (f_at.degree() < f.degree()) continue;
    evaluate(g_modular, h, g_at);
    mp_limb_t value = 0;
    if (!g_at.is_zero()) {
      value = nmod_poly_resultant(f_at.get(), g_at.get());
      const mp_limb_t leading = nmod_poly_get_coeff_ui(f_at.get(), f.degree());
      value = field.multiply(value, field.power(leading, static_cast<unsigned long>(g.degree() - g_at.degree())));
    } else if (f.degree() == 0) {
      value = field.power(nmod_poly_get_coeff_ui(f_at.get(), 0), static_cast<unsigned long>(g.degree()));
    }
    if ((f.degree() * g.degree()) % 2 != 0) value = field.negate(value);
    points.push_back(h);
    values.push_back(value);
  }
  return interpolate(field, std::move(points), std::move(values));
}

UnivariatePolynomial resultant(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g, std::uint64_t seed,
                               const Context& context) {
  if (f.degree() < 0 || g.degree() < 0)
    throw InvalidInput("the resultant of a zero polynomial was asked for", "two non-zero polynomials");
  const Integer bound = power(squared_row_norm(f), static_cast<unsigned long>(g.degree())) *
                        power(squared_row_norm(g), static_cast<unsigned long>(f.degree()));
  const unsigned long bits_needed = bound.bit_length() / 2 + 2;
  PrimeSequence primes(seed);
  UnivariatePolynomial result;
  Integer modulus(1);
  for (unsigned long bits = 0; bits < bits_needed;) {
    context.checkpoint("elimination");
    const PrimeField field(primes.next());
    const auto image = resultant_modulo(f, g, field);
    if (!image) continue;
    if (bits == 0)
      fmpz_poly_set_nmod_poly(result.get(), image->get());
    else
      fmpz_poly_CRT_ui(result.get(), result.get(), modulus.get(), image->get(), 1);
    fmpz_mul_ui(modulus.get(), modulus.get(), field.prime());
    bits += 61;
  }
  return result;
}

}  // namespace eliminant::symbolic
