// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/geometry/border_curve.hpp>

#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/rational_univariate.hpp>

namespace eliminant::symbolic {

namespace {

Rational power_of(const Rational& base, unsigned long exponent) {
  Rational result;
  fmpq_pow_si(result.get(), base.get(), static_cast<slong>(exponent));
  return result;
}

}  // namespace

std::optional<RationalCurve> border_curve(const RationalSurface& surface, std::size_t axis,
                                          const std::optional<Rational>& value) {
  const bool triangular = surface.kind() == RationalSurface::Kind::triangular;
  if (triangular && !(value && value->is_zero()))
    throw InvalidInput("a border of a triangular surface is not at 0", "the value 0");
  const std::size_t other = triangular ? (axis + 1) % 3 : 1 - axis;
  std::vector<RationalUnivariate> coordinates;
  Integer denominator(1);
  for (const Polynomial& f : surface.coordinates()) {
    RationalUnivariate& restricted = coordinates.emplace_back();
    for (const Polynomial::Term& term : f.terms()) {
      Rational factor = term.coefficient;
      if (value)
        factor = factor * power_of(*value, term.exponents[axis]);
      else if (static_cast<long>(term.exponents[axis]) != surface.bidegree()[axis])
        continue;
      const auto exponent = static_cast<slong>(term.exponents[other]);
      Rational sum;
      fmpq_poly_get_coeff_fmpq(sum.get(), restricted.get(), exponent);
      sum = sum + factor;
      fmpq_poly_set_coeff_fmpq(restricted.get(), exponent, sum.get());
    }
    fmpz_lcm(denominator.get(), denominator.get(), fmpq_poly_denref(restricted.get()));
  }
  std::vector<UnivariatePolynomial> integral;
  for (RationalUnivariate& restricted : coordinates) {
    fmpq_poly_scalar_mul_fmpz(restricted.get(), restricted.get(), denominator.get());
    integral.push_back(restricted.numerator());
  }
  if (std::all_of(integral.begin(), integral.end(), [](const UnivariatePolynomial& p) { return p.is_zero(); }))
    return std::nullopt;
  return RationalCurve(integral);
}

}  // namespace eliminant::symbolic
