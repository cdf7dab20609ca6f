// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/symbolic/arithmetic/integer.hpp>

namespace eliminant::symbolic {

/// A rational number in lowest terms, with positive denominator.
class Rational {
 public:
  Rational() { fmpq_init(value_); }
  Rational(long value) : Rational() { fmpq_set_si(value_, value, 1); }  // NOLINT(google-explicit-constructor)
  Rational(int value) : Rational(static_cast<long>(value)) {}           // NOLINT: the literal 0 is also a null pointer
  Rational(const Integer& value) : Rational() {                         // NOLINT(google-explicit-constructor)
    fmpz_set(fmpq_numref(value_), value.get());
  }
  /// numerator / denominator. Throws InvalidInput when the denominator is 0.
  Rational(const Integer& numerator, const Integer& denominator);
  explicit Rational(const fmpq_t value) : Rational() { fmpq_set(value_, value); }
  Rational(const Rational& other) : Rational() { fmpq_set(value_, other.value_); }
  Rational(Rational&& other) noexcept : Rational() { fmpq_swap(value_, other.value_); }
  Rational& operator=(const Rational& other) {
    fmpq_set(value_, other.value_);
    return *this;
  }
  Rational& operator=(Rational&& other) noexcept {
    fmpq_swap(value_, other.value_);
    return *this;
  }
  ~Rational() { fmpq_clear(value_); }

  fmpq* get() { return value_; }
  const fmpq* get() const { return value_; }

  Integer numerator() const { return Integer(fmpq_numref(value_)); }
  Integer denominator() const { return Integer(fmpq_denref(value_)); }
  bool is_zero() const { return fmpq_is_zero(value_) != 0; }
  bool is_integer() const { return fmpz_is_one(fmpq_denref(value_)) != 0; }
  int sign() const { return fmpq_sgn(value_); }
  /// `a` or `a/b`.
  std::string to_string() const;

  friend bool operator==(const Rational& a, const Rational& b) { return fmpq_equal(a.value_, b.value_) != 0; }
  friend bool operator<(const Rational& a, const Rational& b) { return fmpq_cmp(a.value_, b.value_) < 0; }
  friend Rational operator+(const Rational& a, const Rational& b) {
    Rational sum;
    fmpq_add(sum.value_, a.value_, b.value_);
    return sum;
  }
  friend Rational operator-(const Rational& a, const Rational& b) {
    Rational difference;
    fmpq_sub(difference.value_, a.value_, b.value_);
    return difference;
  }
  friend Rational operator*(const Rational& a, const Rational& b) {
    Rational product;
    fmpq_mul(product.value_, a.value_, b.value_);
    return product;
  }
  /// Throws InvalidInput when b is 0.
  friend Rational operator/(const Rational& a, const Rational& b);
  Rational operator-() const {
    Rational negated;
    fmpq_neg(negated.value_, value_);
    return negated;
  }

 private:
  fmpq_t value_;
};

}  // namespace eliminant::symbolic
