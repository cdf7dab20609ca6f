// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/rounding/rational_double.hpp>

#include <eliminant/bridge/enclosures/ball.hpp>

namespace eliminant::bridge {

double nearest(const symbolic::Rational& value) {
  RealBall ball;
  arb_set_fmpq(ball.get(), value.get(), 64);
  return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
}

symbolic::Rational exactly(double value) {
  RealBall ball;
  arb_set_d(ball.get(), value);
  symbolic::Rational result;
  arf_get_fmpq(result.get(), arb_midref(ball.get()));
  return result;
}

}  // namespace eliminant::bridge
