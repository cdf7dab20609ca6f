// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace eliminant::bridge {

/// A closed interval with ends in doubles; every operation widens the result by more than the hardware rounds, so that
/// no rounding mode has to be set.
struct DoubleInterval {
  double lower = 0;
  double upper = 0;

  DoubleInterval() = default;
  DoubleInterval(double value) : lower(value), upper(value) {}  // NOLINT(google-explicit-constructor)
  DoubleInterval(double low, double high) : lower(low), upper(high) {}

  static DoubleInterval widened(double low, double high) {
    const double slack = 0x1p-51 * std::max(std::fabs(low), std::fabs(high)) + 0x1p-1000;
    return {low - slack, high + slack};
  }
  /// The numbers within `radius` of `middle`.
  static DoubleInterval around(double middle, double radius) { return widened(middle - radius, middle + radius); }

  double magnitude() const { return std::max(std::fabs(lower), std::fabs(upper)); }
  /// False also when an end is not a number.
  bool excludes_zero() const { return (lower > 0 && upper > 0) || (lower < 0 && upper < 0); }
  bool is_finite() const { return std::isfinite(lower) && std::isfinite(upper); }

  DoubleInterval operator-() const { return {-upper, -lower}; }
  friend DoubleInterval operator+(const DoubleInterval& a, const DoubleInterval& b) {
    return widened(a.lower + b.lower, a.upper + b.upper);
  }
  friend DoubleInterval operator-(const DoubleInterval& a, const DoubleInterval& b) {
    return widened(a.lower - b.upper, a.upper - b.lower);
  }
  /// Everything when an end is not finite.
  friend DoubleInterval operator*(const DoubleInterval& a, const DoubleInterval& b) {
    if (!a.is_finite() || !b.is_finite()) return {-INFINITY, INFINITY};
    const double p = a.lower * b.lower;
    const double q = a.lower * b.upper;
    const double r = a.upper * b.lower;
    const double s = a.upper * b.upper;
    return widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
  }
  /// Everything when b may be 0.
  friend DoubleInterval operator/(const DoubleInterval& a, const DoubleInterval& b) {
    if (!b.excludes_zero()) return {-INFINITY, INFINITY};
    return a * widened(1 / b.upper, 1 / b.lower);
  }
};

}  // namespace eliminant::bridge
