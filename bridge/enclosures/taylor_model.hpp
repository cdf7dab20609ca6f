// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace eliminant::bridge {

/// A function of (x, y) on [-1, 1]^2, as a polynomial of total degree `Order` with coefficients in doubles, and a bound
/// of its difference from that. Powers of a higher degree and roundings go into the bound.
/// Source: Taylor models [BerzMakino1998].
template <std::size_t Order>
class TaylorModel {
 public:
  TaylorModel() = default;
  explicit TaylorModel(double constant) { coefficients_[0] = constant; }

  double constant() const { return coefficients_[0]; }
  /// Of x^i y^j, i + j <= Order.
  double coefficient(std::size_t i, std::size_t j) const { return coefficients_[start(i + j) + j]; }
  /// The bound of the difference.
  double remainder() const { return remainder_; }

  /// Adds c x^i y^j.
  void add_term(double c, std::size_t i, std::size_t j) {
    if (i + j > Order) {
      add_error(std::fabs(c));
      return;
    }
    double& at = coefficients_[start(i + j) + j];
    at += c;
    add_error(roundoff * std::fabs(at));
  }
  /// The function may differ by as much more.
  void add_error(double error) { remainder_ = (remainder_ + error) * growth; }
  /// Adds factor * other.
  void add_product(double factor, const TaylorModel& other) {
    double sizes = 0;
    for (std::size_t k = 0; k < count; ++k) {
      coefficients_[k] += factor * other.coefficients_[k];
      sizes += std::fabs(factor * other.coefficients_[k]) + std::fabs(coefficients_[k]);
    }
    add_error(std::fabs(factor) * other.remainder_ + 2 * roundoff * sizes);
  }

  friend TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
    TaylorModel result;
    const auto by_degree_a = a.sizes();
    const auto by_degree_b = b.sizes();
    for (std::size_t of_a = 0; of_a <= Order; ++of_a)
      for (std::size_t of_b = 0; of_a + of_b <= Order; ++of_b)
        for (std::size_t i = 0; i <= of_a; ++i)
          for (std::size_t j = 0; j <= of_b; ++j)
            result.coefficients_[start(of_a + of_b) + i + j] +=
                a.coefficients_[start(of_a) + i] * b.coefficients_[start(of_b) + j];
    double higher = 0;
    double whole_a = 0;
    double whole_b = 0;
    for (std::size_t n = 0; n <= Order; ++n) {
      whole_a += by_degree_a[n];
      whole_b += by_degree_b[n];
      for (std::size_t m = Order + 1 - n; m <= Order; ++m) higher += by_degree_a[n] * by_degree_b[m];
    }
    result.add_error(higher + static_cast<double>(2 * count) * roundoff * whole_a * whole_b + a.remainder_ * whole_b +
                     b.remainder_ * whole_a + a.remainder_ * b.remainder_);
    return result;
  }
  friend TaylorModel operator-(TaylorModel a, const TaylorModel& b) {
    a.add_product(-1, b);
    return a;
  }

  /// Bounds the absolute value: without that of the constant term, and with it.
  double variation() const {
    double sum = remainder_;
    for (std::size_t k = 1; k < count; ++k) sum += std::fabs(coefficients_[k]);
    return sum * growth;
  }
  double magnitude() const { return (variation() + std::fabs(constant())) * growth; }

 private:
  static constexpr std::size_t count = (Order + 1) * (Order + 2) / 2;
  static constexpr double roundoff = 0x1p-53;
  /// For sums of bounds that are rounded themselves.
  static constexpr double growth = 1 + 1e-13;

  /// Of the terms of total degree n, x^n first.
  static constexpr std::size_t start(std::size_t n) { return n * (n + 1) / 2; }

  /// The sums of absolute values of the terms of each degree.
  std::array<double, Order + 1> sizes() const {
    std::array<double, Order + 1> result{};
    for (std::size_t n = 0; n <= Order; ++n)
      for (std::size_t i = 0; i <= n; ++i) result[n] += std::fabs(coefficients_[start(n) + i]);
    return result;
  }

  std::array<double, count> coefficients_{};
  double remainder_ = 0;
};

}  // namespace eliminant::bridge
