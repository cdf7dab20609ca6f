// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/rounding/simple_fraction.hpp>

#include <cmath>
#include <utility>

namespace eliminant::bridge {

using symbolic::Rational;

std::optional<Rational> simple_fraction(double value, double accuracy, double largest_denominator) {
  constexpr double largest_power_of_two = 0x1p20;
  const double scaled = value * largest_power_of_two;
  if (!(std::fabs(scaled) < 0x1p62)) return std::nullopt;
  if (std::fabs(scaled - std::round(scaled)) <= accuracy * largest_power_of_two)
    return Rational(std::lround(scaled)) / Rational(static_cast<long>(largest_power_of_two));
  double p0 = 0;
  double q0 = 1;
  double p1 = 1;
  double q1 = 0;
  double rest = value;
  constexpr int most_terms = 20;
  for (int i = 0; i < most_terms; ++i) {
    const double whole = std::floor(rest);
    const double p2 = whole * p1 + p0;
    const double q2 = whole * q1 + q0;
    if (!(q2 <= largest_denominator)) return std::nullopt;
    if (std::fabs(value - p2 / q2) <= accuracy)
      return Rational(static_cast<long>(p2)) / Rational(static_cast<long>(q2));
    p0 = std::exchange(p1, p2);
    q0 = std::exchange(q1, q2);
    rest = 1 / (rest - whole);
    if (!std::isfinite(rest)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace eliminant::bridge
