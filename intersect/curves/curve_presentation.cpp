// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/curve_presentation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <eliminant/bridge/enclosures/decimal.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::Rational;

Coordinate rounded(const ComplexBall& value, long exponent) {
  return {value, bridge::round_to_decimal(value.real(), exponent).to_string(),
          bridge::round_to_decimal(value.imaginary(), exponent).to_string(), std::nullopt};
}

bool narrow(const ComplexBall& value, long exponent) {
  // A tenth of a unit: with the rounding that leaves the error below one unit.
  bridge::RealBall unit(bridge::Decimal{symbolic::Integer(1), exponent - 1}.to_rational(), 64);
  bridge::Magnitude smallest;
  arb_get_mag_lower(smallest.get(), unit.get());
  return mag_cmp(arb_radref(value.real()), smallest.get()) <= 0 &&
         mag_cmp(arb_radref(value.imaginary()), smallest.get()) <= 0;
}

/// The printed numbers of a parameter, infinity apart.
std::array<Rational, 2> key(const Coordinate& coordinate) {
  return {symbolic::parse_number(coordinate.real), symbolic::parse_number(coordinate.imaginary)};
}

}  // namespace

int compare_parameters(const std::optional<Parameter>& a, const std::optional<Parameter>& b) {
  if (!a || !b) return 0;
  if (!*a || !*b) return (*a ? 0 : 1) - (*b ? 0 : 1);
  const std::array<Rational, 2> first = key(**a);
  const std::array<Rational, 2> second = key(**b);
  for (std::size_t k = 0; k < 2; ++k)
    if (!(first[k] == second[k])) return first[k] < second[k] ? -1 : 1;
  return 0;
}

std::optional<Coordinate> print_value(const ComplexBall& value, long digits, long& radius_exponent) {
  if (acb_is_zero(value.get()) != 0) return Coordinate{value, "0", "0", Rational(0)};
  if (acb_contains_zero(value.get()) != 0 || acb_is_finite(value.get()) == 0) return std::nullopt;
  if (acb_rel_accuracy_bits(value.get()) < bits_for_digits(digits) - 20) return std::nullopt;
  const long exponent = bridge::decimal_magnitude(value, digits) - digits;
  if (!narrow(value, exponent)) return std::nullopt;
  radius_exponent = std::max(radius_exponent, exponent);
  return rounded(value, exponent);
}

std::optional<std::vector<Coordinate>> print_normalized(const std::vector<ComplexBall>& coordinates, long digits,
                                                        long& radius_exponent) {
  long magnitude = std::numeric_limits<long>::min();
  for (const ComplexBall& value : coordinates) {
    if (acb_is_finite(value.get()) == 0) return std::nullopt;
    if (acb_contains_zero(value.get()) == 0) magnitude = std::max(magnitude, bridge::decimal_magnitude(value, digits));
  }
  const long exponent = magnitude - digits;
  std::vector<Coordinate> printed;
  for (const ComplexBall& value : coordinates) {
    if (!narrow(value, exponent)) return std::nullopt;
    printed.push_back(rounded(value, exponent));
  }
  radius_exponent = std::max(radius_exponent, exponent);
  return printed;
}

std::vector<Coordinate> print_exact_point(const std::vector<Rational>& coordinates, long digits,
                                          long& radius_exponent) {
  for (long precision_bits = 2 * bits_for_digits(digits);; precision_bits *= 2) {
    std::vector<ComplexBall> balls(coordinates.size());
    for (std::size_t k = 0; k < coordinates.size(); ++k)
      arb_set_fmpq(balls[k].real(), coordinates[k].get(), precision_bits);
    if (auto printed = print_point(balls, digits, precision_bits, radius_exponent,
                                   [&](std::size_t k) { return coordinates[k].is_zero(); }))
      return *std::move(printed);
  }
}

bool crowded(const std::vector<CurveSolution>& solutions) {
  const auto radius = [](const CurveSolution& s) {
    return bridge::Decimal{symbolic::Integer(1), s.radius_exponent}.to_rational();
  };
  const auto apart = [](const std::optional<Parameter>& a, const std::optional<Parameter>& b, const Rational& reach) {
    if (!a || !b || a->has_value() != b->has_value()) return a.has_value() && b.has_value();
    if (!*a) return false;
    const std::array<Rational, 2> first = key(**a);
    const std::array<Rational, 2> second = key(**b);
    for (std::size_t k = 0; k < 2; ++k) {
      const Rational difference = first[k] - second[k];
      if (reach < difference || reach < -difference) return true;
    }
    return false;
  };
  const auto meet = [&](const CurveSolution& a, const CurveSolution& b) {
    const Rational reach = radius(a) + radius(b);
    if (apart(a.t, b.t, reach) || apart(a.u, b.u, reach)) return false;
    for (std::size_t k = 0; k < std::min(a.point.size(), b.point.size()); ++k)
      if (apart(Parameter(a.point[k]), Parameter(b.point[k]), reach)) return false;
    if (a.surface_parameters.empty() || b.surface_parameters.empty()) return true;
    for (std::size_t k = 0; k < a.surface_parameters.front().size(); ++k)
      if (apart(a.surface_parameters.front()[k], b.surface_parameters.front()[k], reach)) return false;
    return true;
  };
  // Sorted by t: only neighbours in its real part can meet.
  const auto real_part = [](const CurveSolution& s) {
    return s.t && *s.t ? arf_get_d(arb_midref((*s.t)->ball.real()), ARF_RND_NEAR) : 0.0;
  };
  for (std::size_t i = 0; i < solutions.size(); ++i)
    for (std::size_t j = i + 1; j < solutions.size(); ++j) {
      constexpr double near = 1e-6;
      if (std::fabs(real_part(solutions[j]) - real_part(solutions[i])) >
          near * (1 + std::fabs(real_part(solutions[i]))))
        continue;
      if (meet(solutions[i], solutions[j])) return true;
    }
  return false;
}

void sort_solutions(std::vector<CurveSolution>& solutions) {
  const auto before = [](const std::vector<Parameter>& a, const std::vector<Parameter>& b) {
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
      if (const int order = compare_parameters(a[k], b[k]); order != 0) return order < 0;
    return false;
  };
  for (CurveSolution& solution : solutions)
    std::stable_sort(solution.surface_parameters.begin(), solution.surface_parameters.end(), before);
  std::stable_sort(solutions.begin(), solutions.end(), [](const CurveSolution& a, const CurveSolution& b) {
    const int by_t = compare_parameters(a.t, b.t);
    return by_t != 0 ? by_t < 0 : compare_parameters(a.u, b.u) < 0;
  });
}

}  // namespace eliminant::intersect
