// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/integer.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::symbolic {

/// A polynomial in Z[t], dense.
class UnivariatePolynomial {
 public:
  UnivariatePolynomial() { fmpz_poly_init(value_); }
  /// Coefficients in ascending order.
  explicit UnivariatePolynomial(const std::vector<Integer>& coefficients);
  /// q x - p for the root p / q in lowest terms.
  static UnivariatePolynomial with_root(const Rational& root);
  explicit UnivariatePolynomial(const fmpz_poly_t value) : UnivariatePolynomial() { fmpz_poly_set(value_, value); }
  UnivariatePolynomial(const UnivariatePolynomial& other) : UnivariatePolynomial() {
    fmpz_poly_set(value_, other.value_);
  }
  UnivariatePolynomial(UnivariatePolynomial&& other) noexcept : UnivariatePolynomial() {
    fmpz_poly_swap(value_, other.value_);
  }
  UnivariatePolynomial& operator=(const UnivariatePolynomial& other) {
    fmpz_poly_set(value_, other.value_);
    return *this;
  }
  UnivariatePolynomial& operator=(UnivariatePolynomial&& other) noexcept {
    fmpz_poly_swap(value_, other.value_);
    return *this;
  }
  ~UnivariatePolynomial() { fmpz_poly_clear(value_); }

  fmpz_poly_struct* get() { return value_; }
  const fmpz_poly_struct* get() const { return value_; }

  /// -1 for the zero polynomial.
  long degree() const { return fmpz_poly_degree(value_); }
  bool is_zero() const { return fmpz_poly_is_zero(value_) != 0; }
  Integer coefficient(long exponent) const;
  UnivariatePolynomial derivative() const;
  /// Divided by the content, leading coefficient positive.
  UnivariatePolynomial primitive_part() const;

  friend bool operator==(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
    return fmpz_poly_equal(a.value_, b.value_) != 0;
  }
  friend UnivariatePolynomial operator+(const UnivariatePolynomial& a, const UnivariatePolynomial& b);
  friend UnivariatePolynomial operator-(const UnivariatePolynomial& a, const UnivariatePolynomial& b);
  friend UnivariatePolynomial operator*(const UnivariatePolynomial& a, const UnivariatePolynomial& b);

 private:
  fmpz_poly_t value_;
};

UnivariatePolynomial power(const UnivariatePolynomial& p, unsigned long exponent);

/// Primitive greatest common divisor with positive leading coefficient.
UnivariatePolynomial gcd(const UnivariatePolynomial& a, const UnivariatePolynomial& b);

/// Of a polynomial that is not zero.
bool has_real_root(const UnivariatePolynomial& p);

}  // namespace eliminant::symbolic
