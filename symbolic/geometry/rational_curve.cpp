// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/geometry/rational_curve.hpp>

#include <algorithm>

#include <eliminant/base/error.hpp>

namespace eliminant::symbolic {

RationalCurve::RationalCurve(std::vector<UnivariatePolynomial> coordinates) : coordinates_(std::move(coordinates)) {
  if (coordinates_.size() != 3 && coordinates_.size() != 4)
    throw InvalidInput("a rational curve has " + std::to_string(coordinates_.size()) + " homogeneous coordinates",
                       "three in the plane or four in space, the weight last");
  // The gcd over Z, content included.
  UnivariatePolynomial common;
  for (const UnivariatePolynomial& coordinate : coordinates_)
    fmpz_poly_gcd(common.get(), common.get(), coordinate.get());
  if (common.is_zero())
    throw InvalidInput("all coordinates of a rational curve are zero", "a coordinate that is not zero");
  for (UnivariatePolynomial& coordinate : coordinates_) {
    UnivariatePolynomial quotient;
    fmpz_poly_div(quotient.get(), coordinate.get(), common.get());
    coordinate = std::move(quotient);
    degree_ = std::max(degree_, coordinate.degree());
  }
}

std::vector<Integer> RationalCurve::at_infinity() const {
  std::vector<Integer> point;
  for (const UnivariatePolynomial& coordinate : coordinates_) point.push_back(coordinate.coefficient(degree_));
  return point;
}

std::vector<Rational> RationalCurve::at(const Rational& value) const {
  std::vector<Rational> point(coordinates_.size());
  for (std::size_t i = 0; i < point.size(); ++i)
    fmpz_poly_evaluate_fmpq(point[i].get(), coordinates_[i].get(), value.get());
  return point;
}

RationalCurve rational_curve(const std::vector<std::vector<Rational>>& coefficients) {
  Integer denominator(1);
  for (const auto& coordinate : coefficients)
    for (const Rational& coefficient : coordinate)
      fmpz_lcm(denominator.get(), denominator.get(), fmpq_denref(coefficient.get()));
  std::vector<UnivariatePolynomial> coordinates(coefficients.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    std::vector<Integer> integers;
    for (const Rational& coefficient : coefficients[i])
      integers.push_back((coefficient * Rational(denominator)).numerator());
    coordinates[i] = UnivariatePolynomial(integers);
  }
  return RationalCurve(std::move(coordinates));
}

RationalCurve rational_curve(const std::vector<Polynomial>& coordinates) {
  std::vector<std::vector<Rational>> coefficients(coordinates.size());
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (coordinates[i].variable_count() != 1)
      throw InvalidInput(
          "a coordinate of a rational curve has " + std::to_string(coordinates[i].variable_count()) + " variables",
          "polynomials in one variable");
    coefficients[i].resize(static_cast<std::size_t>(coordinates[i].total_degree() + 1));
    for (const Polynomial::Term& term : coordinates[i].terms()) coefficients[i][term.exponents[0]] = term.coefficient;
  }
  return rational_curve(coefficients);
}

}  // namespace eliminant::symbolic
