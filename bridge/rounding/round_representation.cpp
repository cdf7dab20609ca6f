// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/rounding/round_representation.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/base/error.hpp>

namespace eliminant::bridge {

namespace {

using numeric::Matrix;
using symbolic::RationalSurface;

/// value / 2^scale_log2.
double scaled(const fmpz* value, long scale_log2) {
  constexpr long lowest = -1000;
  slong exponent = 0;
  const double mantissa = fmpz_get_d_2exp(&exponent, value);
  if (mantissa == 0 || exponent - scale_log2 < lowest) return 0;
  return std::ldexp(mantissa, static_cast<int>(exponent - scale_log2));
}

long bits(const fmpz* value) { return static_cast<long>(fmpz_bits(value)); }

}  // namespace

numeric::CurveForms round_curve(const symbolic::RationalCurve& curve) {
  long scale_log2 = 0;
  for (const symbolic::UnivariatePolynomial& f : curve.coordinates())
    for (long i = 0; i <= f.degree(); ++i) scale_log2 = std::max(scale_log2, bits(f.coefficient(i).get()));
  numeric::CurveForms result;
  result.coefficients.setZero(4, curve.degree() + 1);
  for (std::size_t k = 0; k < curve.coordinates().size(); ++k)
    for (long i = 0; i <= curve.coordinates()[k].degree(); ++i)
      result.coefficients(static_cast<long>(k), i) = scaled(curve.coordinates()[k].coefficient(i).get(), scale_log2);
  return result;
}

numeric::SurfaceForms round_surface(const RationalSurface& surface) {
  numeric::SurfaceForms result;
  result.triangular = surface.kind() == RationalSurface::Kind::triangular;
  result.degrees = result.triangular ? std::array<long, 2>{surface.degree(), 0} : surface.bidegree();
  if (std::max(result.degrees[0], result.degrees[1]) > numeric::largest_numeric_degree)
    throw InvalidInput("the degree of the surface is too large for doubles", "degrees up to 31");
  result.coefficients.setZero(4, numeric::monomial_count(result.triangular, result.degrees));
  long scale_log2 = 0;
  for (const symbolic::Polynomial& f : surface.coordinates())
    for (const symbolic::Polynomial::Term& term : f.terms())
      scale_log2 = std::max(scale_log2, bits(term.coefficient.numerator().get()));
  for (std::size_t k = 0; k < 4; ++k)
    for (const symbolic::Polynomial::Term& term : surface.coordinates()[k].terms()) {
      const long column =
          numeric::monomial_index(result.triangular, result.degrees, static_cast<long>(term.exponents[0]),
                                  static_cast<long>(term.exponents[1]));
      result.coefficients(static_cast<long>(k), column) = scaled(term.coefficient.numerator().get(), scale_log2);
    }
  return result;
}

numeric::MovingPlaneBlocks round_representation(const symbolic::MatrixRepresentation& m, RationalSurface::Kind kind) {
  numeric::MovingPlaneBlocks result;
  result.triangular = kind == RationalSurface::Kind::triangular;
  for (const std::vector<unsigned long>& exponents : m.row_monomials)
    for (std::size_t k = 0; k < 2; ++k)
      result.row_degrees[k] = std::max(result.row_degrees[k], static_cast<long>(exponents[k]));
  if (result.triangular) result.row_degrees[1] = 0;
  for (Matrix<double>& block : result.blocks) block.resize(m.rows(), m.columns());
  for (long j = 0; j < m.columns(); ++j) {
    long scale_log2 = 0;
    for (const symbolic::IntegerMatrix& block : m.coefficients)
      for (long i = 0; i < m.rows(); ++i) scale_log2 = std::max(scale_log2, bits(block.entry(i, j)));
    for (long i = 0; i < m.rows(); ++i) {
      const std::vector<unsigned long>& exponents = m.row_monomials[static_cast<std::size_t>(i)];
      const long row = numeric::monomial_index(result.triangular, result.row_degrees, static_cast<long>(exponents[0]),
                                               static_cast<long>(exponents[1]));
      for (std::size_t k = 0; k < 4; ++k) result.blocks[k](row, j) = scaled(m.coefficients[k].entry(i, j), scale_log2);
    }
  }
  return result;
}

}  // namespace eliminant::bridge
