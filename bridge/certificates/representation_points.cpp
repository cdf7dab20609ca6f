// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/certificates/representation_points.hpp>

namespace eliminant::bridge {

std::optional<PlaneBall> point_above(const symbolic::UnivariateRepresentation& representation,
                                     unsigned long multiplicity, const ComplexBall& t, long precision_bits) {
  ComplexBall numerator;
  ComplexBall denominator;
  arb_fmpz_poly_evaluate_acb(numerator.get(), representation.numerator.get(), t.get(), precision_bits);
  arb_fmpz_poly_evaluate_acb(denominator.get(), representation.denominator.get(), t.get(), precision_bits);
  if (acb_contains_zero(denominator.get())) return std::nullopt;
  PlaneBall point;
  acb_mul_ui(denominator.get(), denominator.get(), multiplicity, precision_bits);
  acb_div(point.y.get(), numerator.get(), denominator.get(), precision_bits);
  acb_neg(point.y.get(), point.y.get());
  ComplexBall shift;
  acb_mul_si(shift.get(), point.y.get(), representation.shear, precision_bits);
  acb_sub(point.x.get(), t.get(), shift.get(), precision_bits);
  return point;
}

}  // namespace eliminant::bridge
