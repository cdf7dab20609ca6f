// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <eliminant/symbolic/arithmetic/flint_headers.hpp>

namespace eliminant::symbolic {

/// An integer of any size.
class Integer {
 public:
  Integer() { fmpz_init(value_); }
  Integer(long value) { fmpz_init_set_si(value_, value); }  // NOLINT(google-explicit-constructor): a number is a number
  Integer(int value) : Integer(static_cast<long>(value)) {}  // NOLINT: the literal 0 is also a null pointer
  explicit Integer(const fmpz_t value) { fmpz_init_set(value_, value); }
  /// Reads an optional sign and decimal digits (or digits of `base`). Throws InvalidInput on anything else.
  static Integer from_string(std::string_view digits, int base = 10);
  Integer(const Integer& other) { fmpz_init_set(value_, other.value_); }
  Integer(Integer&& other) noexcept {
    fmpz_init(value_);
    fmpz_swap(value_, other.value_);
  }
  Integer& operator=(const Integer& other) {
    fmpz_set(value_, other.value_);
    return *this;
  }
  Integer& operator=(Integer&& other) noexcept {
    fmpz_swap(value_, other.value_);
    return *this;
  }
  ~Integer() { fmpz_clear(value_); }

  fmpz* get() { return value_; }
  const fmpz* get() const { return value_; }

  bool is_zero() const { return fmpz_is_zero(value_) != 0; }
  int sign() const { return fmpz_sgn(value_); }
  /// Number of binary digits of the absolute value, 0 for 0.
  unsigned long bit_length() const { return static_cast<unsigned long>(fmpz_bits(value_)); }
  std::string to_string() const;

  friend bool operator==(const Integer& a, const Integer& b) { return fmpz_equal(a.value_, b.value_) != 0; }
  friend Integer operator+(const Integer& a, const Integer& b) {
    Integer sum;
    fmpz_add(sum.value_, a.value_, b.value_);
    return sum;
  }
  friend Integer operator-(const Integer& a, const Integer& b) {
    Integer difference;
    fmpz_sub(difference.value_, a.value_, b.value_);
    return difference;
  }
  friend Integer operator*(const Integer& a, const Integer& b) {
    Integer product;
    fmpz_mul(product.value_, a.value_, b.value_);
    return product;
  }
  Integer operator-() const {
    Integer negated;
    fmpz_neg(negated.value_, value_);
    return negated;
  }

 private:
  fmpz_t value_;
};

/// base^exponent.
Integer power(const Integer& base, unsigned long exponent);

}  // namespace eliminant::symbolic
