// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/ball_curve.hpp>

namespace eliminant::bridge {

BallCurve::BallCurve(const symbolic::Polynomial& p) : by_y_(symbolic::hide_variable(p, 0).coefficients) {}

BallJet BallCurve::jet(const PlaneBall& point, long precision_bits) const {
  BallJet result;
  ComplexBall row;
  ComplexBall row_dx;
  for (std::size_t j = by_y_.size(); j-- > 0;) {
    acb_zero(row.get());
    acb_zero(row_dx.get());
    const fmpz_poly_struct* const coefficients = by_y_[j].get();
    for (slong i = fmpz_poly_length(coefficients); i-- > 0;) {
      acb_mul(row_dx.get(), row_dx.get(), point.x.get(), precision_bits);
      acb_add(row_dx.get(), row_dx.get(), row.get(), precision_bits);
      acb_mul(row.get(), row.get(), point.x.get(), precision_bits);
      acb_add_fmpz(row.get(), row.get(), fmpz_poly_get_coeff_ptr(coefficients, i), precision_bits);
    }
    acb_mul(result.dy.get(), result.dy.get(), point.y.get(), precision_bits);
    acb_add(result.dy.get(), result.dy.get(), result.value.get(), precision_bits);
    acb_mul(result.value.get(), result.value.get(), point.y.get(), precision_bits);
    acb_add(result.value.get(), result.value.get(), row.get(), precision_bits);
    acb_mul(result.dx.get(), result.dx.get(), point.y.get(), precision_bits);
    acb_add(result.dx.get(), result.dx.get(), row_dx.get(), precision_bits);
  }
  return result;
}

ComplexBall BallCurve::value(const PlaneBall& point, long precision_bits) const {
  ComplexBall sum;
  ComplexBall row;
  for (std::size_t j = by_y_.size(); j-- > 0;) {
    arb_fmpz_poly_evaluate_acb(row.get(), by_y_[j].get(), point.x.get(), precision_bits);
    acb_mul(sum.get(), sum.get(), point.y.get(), precision_bits);
    acb_add(sum.get(), sum.get(), row.get(), precision_bits);
  }
  return sum;
}

}  // namespace eliminant::bridge
