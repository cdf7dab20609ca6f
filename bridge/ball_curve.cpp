// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/ball_curve.hpp>

namespace eliminant::bridge {

namespace {

/// |z| as a real ball, rounded up, and the distance of the corners from the midpoint.
struct Reach {
  RealBall modulus;   ///< upper bound of |z| on the ball
  RealBall distance;  ///< upper bound of |z - midpoint|
};

constexpr long bound_bits = 30;

Reach reach(const ComplexBall& z) {
  Reach result;
  mag_t magnitude;
  mag_t distance;
  mag_init(magnitude);
  mag_init(distance);
  acb_get_mag(magnitude, z.get());
  arf_set_mag(arb_midref(result.modulus.get()), magnitude);
  mag_hypot(distance, arb_radref(z.real()), arb_radref(z.imaginary()));
  arf_set_mag(arb_midref(result.distance.get()), distance);
  mag_clear(distance);
  mag_clear(magnitude);
  return result;
}

/// Adds an upper bound of a * d + b * e to the error of z, or of its real part only.
void widen(ComplexBall& z, const RealBall& a, const RealBall& d, const RealBall& b, const RealBall& e, bool real) {
  RealBall sum;
  arb_mul(sum.get(), a.get(), d.get(), bound_bits);
  arb_addmul(sum.get(), b.get(), e.get(), bound_bits);
  mag_t error;
  mag_init(error);
  arb_get_mag(error, sum.get());
  arb_add_error_mag(z.real(), error);
  if (!real) arb_add_error_mag(z.imaginary(), error);
  mag_clear(error);
}

}  // namespace

BallCurve::BallCurve(const symbolic::Polynomial& p) : outer_is_y_(p.degree(0) >= p.degree(1)) {
  rows_ = symbolic::hide_variable(p, outer_is_y_ ? 0 : 1).coefficients;
  for (const auto& row : rows_) row_derivatives_.push_back(row.derivative());
}

BallJet BallCurve::jet(const PlaneBall& point, long precision_bits) const {
  const ComplexBall& inner = outer_is_y_ ? point.x : point.y;
  const ComplexBall& outer = outer_is_y_ ? point.y : point.x;
  BallJet result;
  ComplexBall& d_inner = outer_is_y_ ? result.dx : result.dy;
  ComplexBall& d_outer = outer_is_y_ ? result.dy : result.dx;
  ComplexBall row;
  for (std::size_t j = rows_.size(); j-- > 0;) {
    acb_mul(d_outer.get(), d_outer.get(), outer.get(), precision_bits);
    acb_add(d_outer.get(), d_outer.get(), result.value.get(), precision_bits);
    arb_fmpz_poly_evaluate_acb(row.get(), rows_[j].get(), inner.get(), precision_bits);
    acb_mul(result.value.get(), result.value.get(), outer.get(), precision_bits);
    acb_add(result.value.get(), result.value.get(), row.get(), precision_bits);
    arb_fmpz_poly_evaluate_acb(row.get(), row_derivatives_[j].get(), inner.get(), precision_bits);
    acb_mul(d_inner.get(), d_inner.get(), outer.get(), precision_bits);
    acb_add(d_inner.get(), d_inner.get(), row.get(), precision_bits);
  }
  return result;
}

ComplexBall BallCurve::value(const PlaneBall& point, long precision_bits) const {
  const ComplexBall& inner = outer_is_y_ ? point.x : point.y;
  const ComplexBall& outer = outer_is_y_ ? point.y : point.x;
  ComplexBall sum;
  ComplexBall row;
  for (std::size_t j = rows_.size(); j-- > 0;) {
    arb_fmpz_poly_evaluate_acb(row.get(), rows_[j].get(), inner.get(), precision_bits);
    acb_mul(sum.get(), sum.get(), outer.get(), precision_bits);
    acb_add(sum.get(), sum.get(), row.get(), precision_bits);
  }
  return sum;
}

BallSlopes BallCurve::slopes_on(const PlaneBall& box, long precision_bits) const {
  PlaneBall middle = box;
  acb_get_mid(middle.x.get(), middle.x.get());
  acb_get_mid(middle.y.get(), middle.y.get());
  BallJet at_middle = jet(middle, precision_bits);
  const Reach inner = reach(outer_is_y_ ? box.x : box.y);
  const Reach outer = reach(outer_is_y_ ? box.y : box.x);
  // Second derivatives of the polynomial of absolute coefficients; d_outer2 is half of one.
  RealBall value;
  RealBall d_inner;
  RealBall d_outer;
  RealBall d_inner2;
  RealBall d_inner_outer;
  RealBall d_outer2;
  const auto advance = [&](RealBall& sum, const RealBall& next) {
    arb_mul(sum.get(), sum.get(), outer.modulus.get(), bound_bits);
    arb_add(sum.get(), sum.get(), next.get(), bound_bits);
  };
  RealBall coefficient;
  for (std::size_t j = rows_.size(); j-- > 0;) {
    RealBall row;
    RealBall row_d;
    RealBall row_d2;  // half of the second derivative
    const auto advance_row = [&](RealBall& sum, const RealBall& next) {
      arb_mul(sum.get(), sum.get(), inner.modulus.get(), bound_bits);
      arb_add(sum.get(), sum.get(), next.get(), bound_bits);
    };
    for (long i = rows_[j].degree(); i >= 0; --i) {
      arb_set_round_fmpz(coefficient.get(), fmpz_poly_get_coeff_ptr(rows_[j].get(), i), bound_bits);
      arb_abs(coefficient.get(), coefficient.get());
      advance_row(row_d2, row_d);
      advance_row(row_d, row);
      advance_row(row, coefficient);
    }
    arb_mul_2exp_si(row_d2.get(), row_d2.get(), 1);
    advance(d_outer2, d_outer);
    advance(d_outer, value);
    advance(d_inner_outer, d_inner);
    advance(value, row);
    advance(d_inner, row_d);
    advance(d_inner2, row_d2);
  }
  arb_mul_2exp_si(d_outer2.get(), d_outer2.get(), 1);
  BallSlopes slopes{std::move(at_middle.dx), std::move(at_middle.dy)};
  ComplexBall& inner_slope = outer_is_y_ ? slopes.dx : slopes.dy;
  ComplexBall& outer_slope = outer_is_y_ ? slopes.dy : slopes.dx;
  const bool real = acb_is_real(box.x.get()) != 0 && acb_is_real(box.y.get()) != 0;
  widen(inner_slope, d_inner2, inner.distance, d_inner_outer, outer.distance, real);
  widen(outer_slope, d_inner_outer, inner.distance, d_outer2, outer.distance, real);
  return slopes;
}

}  // namespace eliminant::bridge
