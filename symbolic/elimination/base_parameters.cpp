// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/base_parameters.hpp>

#include <array>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>

namespace eliminant::symbolic {

namespace {

bool divides(const UnivariatePolynomial& f, const UnivariatePolynomial& g) {
  UnivariatePolynomial quotient;
  return fmpz_poly_divides(quotient.get(), g.get(), f.get()) != 0;
}

/// sum_j p_j e^j (1 + shift e)^(degree - j), the hidden variable at `index`.
HiddenVariablePolynomial moved(const Polynomial& p, std::size_t index, long degree, long shift) {
  const HiddenVariablePolynomial hidden = hide_variable(p, index);
  const UnivariatePolynomial line({Integer(1), Integer(shift)});
  HiddenVariablePolynomial result;
  result.coefficients.resize(static_cast<std::size_t>(degree) + 1);
  for (long j = 0; j <= hidden.degree(); ++j) {
    const UnivariatePolynomial factor = power(line, static_cast<unsigned long>(degree - j));
    for (long k = 0; k <= factor.degree(); ++k) {
      UnivariatePolynomial product;
      fmpz_poly_scalar_mul_fmpz(product.get(), hidden.coefficients[static_cast<std::size_t>(j)].get(),
                                factor.coefficient(k).get());
      UnivariatePolynomial& sum = result.coefficients[static_cast<std::size_t>(j + k)];
      sum = sum + product;
    }
  }
  while (!result.coefficients.empty() && result.coefficients.back().is_zero()) result.coefficients.pop_back();
  return result;
}

}  // namespace

bool has_base_point_above(const RationalSurface& surface, std::size_t index, const UnivariatePolynomial& f,
                          const Context& context) {
  if (surface.kind() != RationalSurface::Kind::tensor_product)
    throw InvalidInput("base points above one parameter of a surface over a triangle were asked for",
                       "a surface with two affine parameters");
  const long degree = surface.bidegree()[1 - index];
  for (std::size_t a = 0; a < 4; ++a) {
    const Polynomial& coordinate = surface.coordinates()[a];
    // A polynomial of this degree that is not zero at a root of f has full degree for all but so many changes.
    for (long shift = 0; shift <= degree; ++shift) {
      const HiddenVariablePolynomial whole = moved(coordinate, index, degree, shift);
      if (whole.degree() < degree || divides(f, whole.leading_coefficient())) continue;
      for (long x = 0; x <= 2 * degree; ++x) {
        Polynomial combination(2);
        Rational weight(1);
        for (std::size_t k = 1; k < 4; ++k) {
          combination = combination + weight * surface.coordinates()[(a + k) % 4];
          weight = weight * Rational(x);
        }
        if (combination.is_zero()) continue;
        if (!divides(f, resultant(whole, moved(combination, index, degree, shift), 0, context))) return false;
      }
      return true;
    }
  }
  // All coordinates vanish above the roots: f would be a common factor.
  return true;
}

}  // namespace eliminant::symbolic
