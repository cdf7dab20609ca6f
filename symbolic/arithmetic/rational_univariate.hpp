// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::symbolic {

/// A polynomial in Q[t]: RAII around FLINT's type, for arithmetic modulo a polynomial.
class RationalUnivariate {
 public:
  RationalUnivariate() { fmpq_poly_init(value_); }
  explicit RationalUnivariate(const UnivariatePolynomial& p) : RationalUnivariate() {
    fmpq_poly_set_fmpz_poly(value_, p.get());
  }
  RationalUnivariate(const RationalUnivariate& other) : RationalUnivariate() { fmpq_poly_set(value_, other.value_); }
  RationalUnivariate(RationalUnivariate&& other) noexcept : RationalUnivariate() {
    fmpq_poly_swap(value_, other.value_);
  }
  RationalUnivariate& operator=(RationalUnivariate other) noexcept {
    fmpq_poly_swap(value_, other.value_);
    return *this;
  }
  ~RationalUnivariate() { fmpq_poly_clear(value_); }
  fmpq_poly_struct* get() { return value_; }
  const fmpq_poly_struct* get() const { return value_; }
  bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
  /// Numerator over the common denominator.
  UnivariatePolynomial numerator() const {
    UnivariatePolynomial result;
    fmpq_poly_get_numerator(result.get(), value_);
    return result;
  }

 private:
  fmpq_poly_t value_;
};

}  // namespace eliminant::symbolic
