// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::symbolic {

/// Upper bounds of a polynomial that has not been expanded. All counts saturate instead of overflowing.
struct ExpressionSize {
  std::uint64_t degree = 0;
  std::uint64_t terms = 1;
  /// log2 of the sum of the absolute values of the numerators over the common `denominator`: 0 for a monomial.
  std::uint64_t coefficient_bits = 0;
  /// Binary length of all numerators together.
  std::uint64_t total_bits = 1;
  Integer denominator{1};
};

/// Bounds of sums, products and powers, computed without expanding them. Each function throws LimitReached
/// (without a place, which only the parser knows) as soon as a bound exceeds a limit.
class SizeBounds {
 public:
  SizeBounds(std::size_t variable_count, const Limits& limits) : variable_count_(variable_count), limits_(limits) {}

  static ExpressionSize of_constant(const Rational& value);
  static ExpressionSize of_variable();
  ExpressionSize of_sum(std::span<const ExpressionSize* const> addends) const;
  ExpressionSize of_product(std::span<const ExpressionSize* const> factors) const;
  ExpressionSize of_power(const ExpressionSize& base, std::uint64_t exponent) const;

 private:
  // Number of monomials of at most this degree.
  std::uint64_t monomials_up_to(std::uint64_t degree) const;
  void check(const ExpressionSize& size) const;
  void check_coefficient_bits(std::uint64_t bits) const;

  std::size_t variable_count_;
  Limits limits_;
};

/// a + b and a * b, or the largest value where that would overflow.
std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b);
std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b);

}  // namespace eliminant::symbolic
