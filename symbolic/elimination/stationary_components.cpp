// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/stationary_components.hpp>

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>
#include <eliminant/symbolic/elimination/bezoutian_minors.hpp>
#include <eliminant/symbolic/elimination/component_observer.hpp>
#include <eliminant/symbolic/elimination/factors.hpp>

#include <flint/nmod_poly_mat.h>

namespace eliminant::symbolic {

namespace {

/// The surface with its parameters in the other order.
RationalSurface exchanged(const RationalSurface& surface) {
  std::vector<Polynomial> coordinates;
  const std::vector<Polynomial> images{Polynomial::variable(2, 1), Polynomial::variable(2, 0)};
  for (const Polynomial& coordinate : surface.coordinates()) coordinates.push_back(coordinate.compose(images));
  return {RationalSurface::Kind::tensor_product, std::move(coordinates)};
}

/// det B(x, .) modulo a prime for one value of the first kept parameter.
ModularPolynomial determinant_on_line(const SeparatedBezoutian& matrix, mp_limb_t x, const PrimeField& field) {
  const PolynomialMatrix value = matrix.at_first_parameter(Rational(static_cast<long>(x)));
  nmod_poly_mat_t reduced;
  nmod_poly_mat_init(reduced, value.rows(), value.columns(), field.prime());
  for (long i = 0; i < value.rows(); ++i)
    for (long j = 0; j < value.columns(); ++j)
      fmpz_poly_get_nmod_poly(nmod_poly_mat_entry(reduced, i, j), value.entry(i, j).get());
  ModularPolynomial result(field);
  nmod_poly_mat_det(result.get(), reduced);
  nmod_poly_mat_clear(reduced);
  return result;
}

/// Whether the determinant may have a factor in the second kept parameter alone.
bool may_have_factor(const SeparatedBezoutian& matrix, std::uint64_t seed) {
  const PrimeField field(PrimeSequence(mix(seed, 11)).next());
  constexpr mp_limb_t range = mp_limb_t{1} << 30U;
  ModularPolynomial common(field);
  for (const std::uint64_t k : {12UL, 13UL})
    nmod_poly_gcd(common.get(), common.get(), determinant_on_line(matrix, mix(seed, k) % range, field).get());
  return common.degree() != 0;
}

/// The values of the second kept parameter (t) above which `first`, whose second parameter is eliminated, meets
/// `second` along a curve on which that parameter stands still.
std::vector<UnivariatePolynomial> stationary_values(const RationalSurface& first, const RationalSurface& second,
                                                    std::uint64_t seed, const Context& context) {
  std::vector<UnivariatePolynomial> result;
  const SeparatedBezoutian matrix(first, second);
  if (!may_have_factor(matrix, seed)) return result;
  const ComponentObserver observer(first, second, false, seed);
  if (observer.anywhere(0).finite > 0) return result;  // they overlap
  Polynomial divisor = bezoutian_determinant(matrix, seed, context);
  if (divisor.is_zero()) divisor = bezoutian_minors(matrix, seed, context).gcd;
  UnivariatePolynomial content;
  for (const UnivariatePolynomial& coefficient : hide_variable(divisor, 1).coefficients)
    content = gcd(content, coefficient);
  if (content.degree() < 1) return result;
  for (const UnivariatePolynomial& factor : irreducible_factors(content)) {
    if (factor.degree() < 1) continue;
    std::vector<Polynomial::Term> terms;
    for (long k = 0; k <= factor.degree(); ++k)
      terms.push_back({Rational(factor.coefficient(k)), {0, static_cast<unsigned long>(k)}});
    const std::optional<Observation> seen = observer.on(Polynomial::from_terms(2, terms), 1);
    if (seen && seen->meetings.finite > 0 && seen->one_parameter && !seen->one_image)
      result.push_back(factor.primitive_part());
  }
  return result;
}

}  // namespace

StationaryComponents stationary_components(const RationalSurface& first, const RationalSurface& second,
                                           std::uint64_t seed, const Context& context) {
  const RationalSurface first_exchanged = exchanged(first);
  // Kept (s, u), then (v, t).
  return {stationary_values(second, first_exchanged, seed, context),
          stationary_values(first_exchanged, second, seed, context)};
}

}  // namespace eliminant::symbolic
