// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/geometry/bezier.hpp>

#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/rational_univariate.hpp>

namespace eliminant::symbolic {

namespace {

Integer binomial(std::size_t n, std::size_t k) {
  Integer result;
  fmpz_bin_uiui(result.get(), n, k);
  return result;
}

// Multiplies the values by their common denominator and returns it.
Integer clear_denominators(const std::vector<Rational>& values, std::vector<Integer>& integers) {
  Integer denominator(1);
  for (const Rational& value : values) fmpz_lcm(denominator.get(), denominator.get(), fmpq_denref(value.get()));
  for (const Rational& value : values) integers.push_back((value * Rational(denominator)).numerator());
  return denominator;
}

void require_coordinates(const ControlPoint& point, std::size_t count) {
  if (point.size() != count)
    throw InvalidInput("control points have " + std::to_string(count) + " and " + std::to_string(point.size()) +
                           " homogeneous coordinates",
                       "points of one dimension");
}

}  // namespace

std::vector<Rational> power_coefficients(const std::vector<Rational>& bernstein_coefficients,
                                         const Interval& interval) {
  if (bernstein_coefficients.empty()) throw InvalidInput("a Bezier form has no coefficients", "at least one");
  if (!(interval.lower < interval.upper))
    throw InvalidInput("the domain of a Bezier form is a point", "lower end < upper end");
  const std::size_t degree = bernstein_coefficients.size() - 1;
  std::vector<Integer> differences;
  const Integer denominator = clear_denominators(bernstein_coefficients, differences);
  // In v = (t - lower) / (upper - lower): binomial(degree, k) times the k-th forward difference at v^k.
  RationalUnivariate in_unit;
  for (std::size_t k = 0; k <= degree; ++k) {
    const Rational coefficient(binomial(degree, k) * differences.front(), denominator);
    fmpq_poly_set_coeff_fmpq(in_unit.get(), static_cast<slong>(k), coefficient.get());
    for (std::size_t i = 0; i + 1 < differences.size(); ++i)
      fmpz_sub(differences[i].get(), differences[i + 1].get(), differences[i].get());
    differences.pop_back();
  }
  const Rational slope = Rational(1) / (interval.upper - interval.lower);
  const Rational shift = -interval.lower * slope;
  RationalUnivariate inner;
  fmpq_poly_set_coeff_fmpq(inner.get(), 0, shift.get());
  fmpq_poly_set_coeff_fmpq(inner.get(), 1, slope.get());
  RationalUnivariate in_parameter;
  fmpq_poly_compose(in_parameter.get(), in_unit.get(), inner.get());
  std::vector<Rational> coefficients(degree + 1);
  for (std::size_t k = 0; k <= degree; ++k)
    fmpq_poly_get_coeff_fmpq(coefficients[k].get(), in_parameter.get(), static_cast<slong>(k));
  return coefficients;
}

std::vector<Rational> bernstein_coefficients(const std::vector<Rational>& power_coefficients,
                                             const Interval& interval) {
  if (power_coefficients.empty()) throw InvalidInput("a polynomial has no coefficients", "at least one");
  RationalUnivariate in_parameter;
  for (std::size_t k = 0; k < power_coefficients.size(); ++k)
    fmpq_poly_set_coeff_fmpq(in_parameter.get(), static_cast<slong>(k), power_coefficients[k].get());
  RationalUnivariate inner;
  fmpq_poly_set_coeff_fmpq(inner.get(), 0, interval.lower.get());
  fmpq_poly_set_coeff_fmpq(inner.get(), 1, (interval.upper - interval.lower).get());
  RationalUnivariate in_unit;
  fmpq_poly_compose(in_unit.get(), in_parameter.get(), inner.get());
  const std::size_t degree = power_coefficients.size() - 1;
  // v^k = sum over j >= k of binomial(j, k) / binomial(degree, k) times the j-th Bernstein polynomial.
  std::vector<Rational> result(degree + 1);
  for (std::size_t k = 0; k <= degree; ++k) {
    Rational coefficient;
    fmpq_poly_get_coeff_fmpq(coefficient.get(), in_unit.get(), static_cast<slong>(k));
    if (coefficient.is_zero()) continue;
    for (std::size_t j = k; j <= degree; ++j)
      result[j] = result[j] + coefficient * Rational(binomial(j, k), binomial(degree, k));
  }
  return result;
}

CurvePiece bezier_curve(const std::vector<ControlPoint>& points, const Interval& domain) {
  if (points.empty()) throw InvalidInput("a Bezier curve has no control points", "degree + 1 points");
  const std::size_t dimension = points.front().size();
  std::vector<std::vector<Rational>> coordinates(dimension);
  for (const ControlPoint& point : points) {
    require_coordinates(point, dimension);
    for (std::size_t c = 0; c < dimension; ++c) coordinates[c].push_back(point[c]);
  }
  for (auto& coordinate : coordinates) coordinate = power_coefficients(coordinate, domain);
  return {rational_curve(coordinates), domain};
}

SurfacePiece bezier_patch(const std::vector<std::vector<ControlPoint>>& rows, const std::array<Interval, 2>& domain) {
  if (rows.empty() || rows.front().empty())
    throw InvalidInput("a Bezier patch has no control points", "rows of control points");
  const std::size_t columns = rows.front().size();
  for (const auto& row : rows) {
    if (row.size() != columns)
      throw InvalidInput("rows of a Bezier patch have " + std::to_string(columns) + " and " +
                             std::to_string(row.size()) + " control points",
                         "rows of one length");
    for (const ControlPoint& point : row) require_coordinates(point, 4);
  }
  std::vector<Polynomial> coordinates;
  for (std::size_t c = 0; c < 4; ++c) {
    // Along each row in the second parameter, then along the columns in the first.
    std::vector<std::vector<Rational>> in_second;
    for (const auto& row : rows) {
      std::vector<Rational> values;
      for (const ControlPoint& point : row) values.push_back(point[c]);
      in_second.push_back(power_coefficients(values, domain[1]));
    }
    std::vector<Polynomial::Term> terms;
    for (unsigned long j = 0; j < columns; ++j) {
      std::vector<Rational> values;
      for (const auto& row : in_second) values.push_back(row[j]);
      values = power_coefficients(values, domain[0]);
      for (unsigned long i = 0; i < values.size(); ++i)
        if (!values[i].is_zero()) terms.push_back({values[i], {i, j}});
    }
    coordinates.push_back(Polynomial::from_terms(2, terms));
  }
  return {RationalSurface(RationalSurface::Kind::tensor_product, std::move(coordinates)),
          ParameterRegion{domain, false}};
}

std::size_t triangle_point_count(std::size_t degree) { return (degree + 1) * (degree + 2) / 2; }

SurfacePiece bezier_triangle(std::size_t degree, const std::vector<ControlPoint>& points) {
  if (points.size() != triangle_point_count(degree))
    throw InvalidInput("a triangular patch of degree " + std::to_string(degree) + " has " +
                           std::to_string(points.size()) + " control points",
                       std::to_string(triangle_point_count(degree)) + " points");
  std::vector<std::vector<Polynomial::Term>> terms(4);
  std::size_t next = 0;
  for (unsigned long not_s = 0; not_s <= degree; ++not_s) {
    for (unsigned long k = 0; k <= not_s; ++k) {
      const ControlPoint& point = points[next++];
      require_coordinates(point, 4);
      const Integer multinomial = binomial(degree, not_s) * binomial(not_s, k);
      for (std::size_t c = 0; c < 4; ++c)
        if (!point[c].is_zero()) terms[c].push_back({Rational(multinomial) * point[c], {degree - not_s, not_s - k, k}});
    }
  }
  std::vector<Polynomial> coordinates;
  for (const auto& of_coordinate : terms) coordinates.push_back(Polynomial::from_terms(3, of_coordinate));
  const Interval unit{0, 1};
  return {RationalSurface(RationalSurface::Kind::triangular, std::move(coordinates)),
          ParameterRegion{{unit, unit}, true}};
}

}  // namespace eliminant::symbolic
