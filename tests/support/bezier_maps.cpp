// SPDX-License-Identifier: BSD-3-Clause
#include <support/bezier_maps.hpp>

#include <algorithm>
#include <utility>

#include <support/binary_numbers.hpp>

namespace eliminant::test {

using symbolic::Integer;

Rational fraction(long numerator, long denominator) { return Rational(Integer(numerator), Integer(denominator)); }

Polynomial t_power(unsigned long exponent) {
  return Polynomial::from_terms(1, std::vector<Polynomial::Term>{{Rational(1), {exponent}}});
}

Polynomial in_t(const std::vector<Rational>& ascending) {
  std::vector<Polynomial::Term> terms;
  for (std::size_t i = 0; i < ascending.size(); ++i) terms.push_back({ascending[i], {i}});
  return Polynomial::from_terms(1, terms);
}

std::vector<Rational> ascending_coefficients(const Polynomial& p, std::size_t degree) {
  std::vector<Rational> result(degree + 1);
  for (const Polynomial::Term& term : p.terms()) result.at(term.exponents[0]) = term.coefficient;
  return result;
}

Rational value(const Polynomial& p, const std::vector<Rational>& point) {
  std::vector<Polynomial> images;
  for (const Rational& coordinate : point) images.push_back(Polynomial::constant(1, coordinate));
  return p.compose(images).constant_term();
}

ControlPoint values(const Map& map, const std::vector<Rational>& point) {
  ControlPoint result;
  for (const Polynomial& p : map) result.push_back(value(p, point));
  return result;
}

Map composed(const Map& map, const std::vector<Polynomial>& parameters) {
  Map result;
  for (const Polynomial& p : map) result.push_back(p.compose(parameters));
  return result;
}

Map curve_map(const RationalPolygon& points) {
  Map result;
  for (std::size_t k = 0; k < coordinates; ++k) {
    std::vector<Rational> bernstein;
    for (const ControlPoint& point : points) bernstein.push_back(point[k]);
    result.push_back(in_t(symbolic::power_coefficients(bernstein, unit)));
  }
  return result;
}

RationalPolygon control_polygon(const Map& map, std::size_t degree) {
  RationalPolygon points(degree + 1, ControlPoint(coordinates));
  for (std::size_t k = 0; k < coordinates; ++k) {
    const auto bernstein = symbolic::bernstein_coefficients(ascending_coefficients(map[k], degree), unit);
    for (std::size_t i = 0; i <= degree; ++i) points[i][k] = bernstein[i];
  }
  return points;
}

Map homogeneous_map(const RationalNet& net) {
  const PatchMap map = patch_map(net);
  return {map.begin(), map.end()};
}

namespace {

/// The common denominator without its powers of two.
Integer odd_denominator(const RationalNet& net, Integer denominator = 1) {
  for (const RationalPolygon& row : net)
    for (const ControlPoint& point : row)
      for (const Rational& number : point) fmpz_lcm(denominator.get(), denominator.get(), fmpq_denref(number.get()));
  const auto twos = fmpz_val2(denominator.get());
  fmpz_tdiv_q_2exp(denominator.get(), denominator.get(), twos);
  return denominator;
}

void scale(RationalNet& net, const Integer& factor, std::size_t count) {
  for (RationalPolygon& row : net)
    for (ControlPoint& point : row)
      for (std::size_t k = 0; k < count; ++k) point[k] = point[k] * Rational(factor);
}

bool has_unit_weights(const RationalNet& net) {
  return std::all_of(net.begin(), net.end(), [](const RationalPolygon& row) {
    return std::all_of(row.begin(), row.end(), [](const ControlPoint& point) { return point.back() == Rational(1); });
  });
}

}  // namespace

BezierCase binary_case(std::string family, const RationalPolygon& curve, RationalNet other) {
  RationalNet first{curve};
  const std::size_t affine = coordinates - 1;
  if (has_unit_weights(first) && has_unit_weights(other)) {
    const Integer factor = odd_denominator(other, odd_denominator(first));
    scale(first, factor, affine);
    scale(other, factor, affine);
  } else {
    scale(first, odd_denominator(first), coordinates);
    scale(other, odd_denominator(other), coordinates);
  }
  BezierCase result;
  result.family = std::move(family);
  result.curve = in_doubles(first).front();
  result.patch = in_doubles(other);
  return result;
}

BezierCase plane_case(std::string family, const RationalPolygon& first, const RationalPolygon& second) {
  BezierCase result = binary_case(std::move(family), first, {second});
  result.second = std::move(result.patch.front());
  result.patch.clear();
  return result;
}

PlantedParameter planted_at(const Rational& parameter, unsigned long multiplicity) {
  PlantedParameter result;
  result.polynomial = {-fmpz_get_si(parameter.numerator().get()), fmpz_get_si(parameter.denominator().get())};
  result.approximation = exact_double(parameter);
  result.multiplicity = multiplicity;
  return result;
}

}  // namespace eliminant::test
