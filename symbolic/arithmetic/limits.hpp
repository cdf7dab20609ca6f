// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace eliminant::symbolic {

/// How large an input may be. Every bound is checked on what an expression could become, before any of it is computed;
/// larger input throws LimitReached.
struct Limits {
  /// Digits of one number as written.
  std::size_t digits = 1'000'000;
  /// Absolute value of a decimal exponent. Binary exponents (`0x1p-3`) may be three times as large.
  std::size_t decimal_exponent = 1'000'000;
  /// Total degree of a polynomial, also of each factor and addend.
  std::size_t degree = 1000;
  /// Terms of a polynomial after expansion.
  std::size_t terms = 1'000'000;
  /// Decimal digits of all coefficients of one polynomial together, and of all its products and powers together.
  std::size_t total_digits = 500'000'000;
  /// Parentheses inside one another.
  std::size_t nesting = 500;

  /// Largest binary length of the numerator or the denominator of a coefficient: a number with as many digits as
  /// allowed may carry the largest exponent allowed. 10/3 > log2(10).
  std::size_t coefficient_bits() const { return (digits + decimal_exponent) * 10 / 3 + 64; }
  std::size_t total_bits() const { return total_digits * 10 / 3; }
};

}  // namespace eliminant::symbolic
