// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>
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

/// Enclosures of the partial derivatives of a polynomial on a box.
struct BallSlopes {
  ComplexBall dx, dy;
};

/// A bivariate polynomial with rational coefficients, to be evaluated in ball arithmetic.
class BallCurve {
 public:
  explicit BallCurve(const symbolic::Polynomial& p);

  /// Encloses p, p_x, p_y on all of `point`, best for points without radius: a rectangle grows in each multiplication.
  BallJet jet(const PlaneBall& point, long precision_bits) const;
  /// Encloses p only.
  ComplexBall value(const PlaneBall& point, long precision_bits) const;
  /// Encloses p_x and p_y on a box by the mean value theorem: the slopes in its midpoint, with the second derivatives
  /// of the polynomial of absolute coefficients at (|x|, |y|) times the distance as their error.
  BallSlopes slopes_on(const PlaneBall& box, long precision_bits) const;

 private:
  struct Sums {
    ComplexBall value, d_inner, d_outer;
  };
  Sums sum_rows(const PlaneBall& point, bool with_derivatives, long precision_bits) const;

  // p times a common denominator, by powers of the outer variable: no effect on the zeros. The inner variable is the
  // one of higher degree, whose polynomials have an evaluation that loses few digits.
  bool outer_is_y_ = true;
  std::vector<symbolic::UnivariatePolynomial> rows_;
  std::vector<symbolic::UnivariatePolynomial> row_derivatives_;
};

}  // namespace eliminant::bridge
