// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/bridge/ball.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>

namespace eliminant::bridge {

/// A point of C^2 in a product of two complex balls.
struct PlaneBall {
  ComplexBall x, y;
};

/// Enclosures of a polynomial and its partial derivatives.
struct BallJet {
  ComplexBall value, dx, dy;
};

/// A bivariate polynomial with rational coefficients, to be evaluated in ball arithmetic.
class BallCurve {
 public:
  explicit BallCurve(const symbolic::Polynomial& p);

  /// Encloses p, p_x, p_y on all of `point`; Horner's rule in x inside Horner's rule in y.
  BallJet jet(const PlaneBall& point, long precision_bits) const;
  /// Encloses p only.
  ComplexBall value(const PlaneBall& point, long precision_bits) const;

 private:
  std::vector<symbolic::UnivariatePolynomial> by_y_;  // p times a common denominator: no effect on its zeros
};

}  // namespace eliminant::bridge
