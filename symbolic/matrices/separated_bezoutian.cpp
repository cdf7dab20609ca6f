// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/matrices/separated_bezoutian.hpp>

#include <algorithm>

#include <eliminant/base/error.hpp>

namespace eliminant::symbolic {

namespace {

/// One coefficient of a curve of the surface: four polynomials in the parameter that is kept, the weight first.
using PointCoordinates = std::array<UnivariatePolynomial, 4>;

std::vector<PointCoordinates> curve_coefficients(const RationalSurface& surface, std::size_t eliminated) {
  if (surface.kind() != RationalSurface::Kind::tensor_product)
    throw InvalidInput("the Bezoutian matrix of a surface over a triangle was asked for",
                       "a surface with two affine parameters");
  const long degree = surface.bidegree()[eliminated];
  if (degree < 1)
    throw InvalidInput("a surface does not depend on the parameter that is to be eliminated: it is a curve",
                       "a surface");
  std::vector<PointCoordinates> result(static_cast<std::size_t>(degree) + 1);
  for (std::size_t k = 0; k < 4; ++k)
    for (const Polynomial::Term& term : surface.coordinates()[(k + 3) % 4].terms())
      fmpz_poly_set_coeff_fmpz(result[term.exponents[eliminated]][k].get(),
                               static_cast<slong>(term.exponents[1 - eliminated]), term.coefficient.numerator().get());
  return result;
}

/// Adds the coordinates of a ^ b in the order 01, 02, 03, 23, 31, 12.
void add_line(SeparatedBezoutian::LineCoordinates& sum, const PointCoordinates& a, const PointCoordinates& b) {
  constexpr std::array<std::array<std::size_t, 2>, 6> pairs{{{0, 1}, {0, 2}, {0, 3}, {2, 3}, {3, 1}, {1, 2}}};
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    sum[k] = sum[k] + (a[i] * b[j] - a[j] * b[i]);
  }
}

/// All sums of lines of one curve; for the second curve in the order of the complements: 23, 31, 12, 01, 02, 03.
std::vector<SeparatedBezoutian::LineCoordinates> line_sums(const std::vector<PointCoordinates>& points, bool second) {
  const std::size_t n = points.size() - 1;
  std::vector<SeparatedBezoutian::LineCoordinates> result(n * n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = j; k < n; ++k) {
      SeparatedBezoutian::LineCoordinates& sum = result[j * n + k];
      const std::size_t power = j + k + 1;
      for (std::size_t p = power > n ? power - n : 0; p <= j; ++p) add_line(sum, points[p], points[power - p]);
      if (second) std::rotate(sum.begin(), sum.begin() + 3, sum.end());
      result[k * n + j] = sum;
    }
  return result;
}

/// p(x) times the denominator of x to the power `degree`.
Integer value_at(const UnivariatePolynomial& p, const Rational& x, long degree) {
  Integer sum;
  for (long k = 0; k <= p.degree(); ++k)
    sum = sum + p.coefficient(k) * power(x.numerator(), static_cast<unsigned long>(k)) *
                    power(x.denominator(), static_cast<unsigned long>(degree - k));
  return sum;
}

}  // namespace

SeparatedBezoutian::SeparatedBezoutian(const RationalSurface& first, const RationalSurface& second) {
  const std::vector<PointCoordinates> a = curve_coefficients(first, 1);
  const std::vector<PointCoordinates> c = curve_coefficients(second, 0);
  n_ = a.size() - 1;
  m_ = c.size() - 1;
  first_ = line_sums(a, false);
  second_ = line_sums(c, true);
}

PolynomialMatrix SeparatedBezoutian::at_first_parameter(const Rational& u) const {
  long degree = 0;
  for (const LineCoordinates& lines : first_)
    for (const UnivariatePolynomial& coordinate : lines) degree = std::max(degree, coordinate.degree());
  std::vector<std::array<Integer, 6>> values(first_.size());
  for (std::size_t k = 0; k < first_.size(); ++k)
    for (std::size_t c = 0; c < 6; ++c) values[k][c] = value_at(first_[k][c], u, degree);
  PolynomialMatrix result(static_cast<long>(size()), static_cast<long>(size()));
  for (std::size_t row = 0; row < size(); ++row)
    for (std::size_t column = 0; column < size(); ++column) {
      const std::array<Integer, 6>& lines = values[(row % n_) * n_ + column % n_];
      const LineCoordinates& others = second_lines(row / n_, column / n_);
      UnivariatePolynomial sum;
      for (std::size_t c = 0; c < 6; ++c) {
        UnivariatePolynomial product;
        fmpz_poly_scalar_mul_fmpz(product.get(), others[c].get(), lines[c].get());
        sum = sum + product;
      }
      result.set_entry(static_cast<long>(row), static_cast<long>(column), sum);
    }
  return result;
}

}  // namespace eliminant::symbolic
