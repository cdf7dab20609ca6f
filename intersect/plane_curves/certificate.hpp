// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::intersect {

/// The polydisc |x - (x_real + i x_imaginary)| <= r, |y - (y_real + i y_imaginary)| <= r, r = 10^radius_exponent, said
/// to hold one solution of this multiplicity, real or not.
struct CertifiedBall {
  symbolic::Rational x_real, x_imaginary, y_real, y_imaginary;
  long radius_exponent = 0;
  unsigned long multiplicity = 1;
  bool real = false;
};

/// All that a proof of the solutions of two plane curves needs to be checked again (check_certificate), without the
/// computation that found them.
struct Certificate {
  std::vector<std::string> variables{"x", "y"};
  symbolic::Polynomial p{2};
  symbolic::Polynomial q{2};
  /// The greatest common divisor where it is not constant; the balls are about the cofactors. 0 when both vanish.
  std::optional<symbolic::Polynomial> common_component;
  unsigned long at_infinity = 0;
  /// How the count is proven. None: by Bezout's theorem, nothing lies at infinity, all solutions are simple. One:
  /// by the degree of the eliminant in t = x + s y, all solutions are simple. Two: by the eliminants in t = x + s y for
  /// both s, and these separate the solutions.
  std::vector<long> shears;
  std::vector<CertifiedBall> balls;
};

}  // namespace eliminant::intersect
