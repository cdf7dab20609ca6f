// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// A real ball [midpoint +- radius] that encloses the number it stands for (Arb).
class RealBall {
 public:
  RealBall() { arb_init(value_); }
  explicit RealBall(const arb_t value) : RealBall() { arb_set(value_, value); }
  /// The ball of `value` rounded to `precision_bits`.
  RealBall(const symbolic::Rational& value, long precision_bits) : RealBall() {
    arb_set_fmpq(value_, value.get(), precision_bits);
  }
  RealBall(const RealBall& other) : RealBall() { arb_set(value_, other.value_); }
  RealBall(RealBall&& other) noexcept : RealBall() { arb_swap(value_, other.value_); }
  RealBall& operator=(const RealBall& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  RealBall& operator=(RealBall&& other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~RealBall() { arb_clear(value_); }
  arb_ptr get() { return value_; }
  arb_srcptr get() const { return value_; }

 private:
  arb_t value_;
};

/// A complex ball: the rectangle of two real balls (Arb).
class ComplexBall {
 public:
  ComplexBall() { acb_init(value_); }
  explicit ComplexBall(const acb_t value) : ComplexBall() { acb_set(value_, value); }
  ComplexBall(double real, double imaginary) : ComplexBall() { acb_set_d_d(value_, real, imaginary); }
  ComplexBall(const ComplexBall& other) : ComplexBall() { acb_set(value_, other.value_); }
  ComplexBall(ComplexBall&& other) noexcept : ComplexBall() { acb_swap(value_, other.value_); }
  ComplexBall& operator=(const ComplexBall& other) {
    acb_set(value_, other.value_);
    return *this;
  }
  ComplexBall& operator=(ComplexBall&& other) noexcept {
    acb_swap(value_, other.value_);
    return *this;
  }
  ~ComplexBall() { acb_clear(value_); }
  acb_ptr get() { return value_; }
  acb_srcptr get() const { return value_; }
  arb_ptr real() { return acb_realref(value_); }
  arb_srcptr real() const { return acb_realref(value_); }
  arb_ptr imaginary() { return acb_imagref(value_); }
  arb_srcptr imaginary() const { return acb_imagref(value_); }

 private:
  acb_t value_;
};

/// The exact midpoint of a ball.
inline ComplexBall midpoint(const ComplexBall& z) {
  ComplexBall result;
  acb_get_mid(result.get(), z.get());
  return result;
}

/// An upper bound of a non-negative number, rounded up by every operation (Arb).
class Magnitude {
 public:
  Magnitude() { mag_init(value_); }
  Magnitude(const Magnitude&) = delete;
  Magnitude& operator=(const Magnitude&) = delete;
  ~Magnitude() { mag_clear(value_); }
  mag_ptr get() { return value_; }
  mag_srcptr get() const { return value_; }

 private:
  mag_t value_;
};

}  // namespace eliminant::bridge
