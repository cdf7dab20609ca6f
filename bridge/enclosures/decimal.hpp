// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/bridge/enclosures/ball.hpp>

namespace eliminant::bridge {

/// The number value * 10^exponent.
struct Decimal {
  symbolic::Integer value;
  long exponent = 0;

  symbolic::Rational to_rational() const;
  /// Without trailing zeros: plain where the number is not too long that way, otherwise like `1.25e-40`.
  std::string to_string() const;
};

/// The number without rounding: as a decimal where it is one, otherwise as a fraction `a/b`.
std::string exact_text(const symbolic::Rational& value);

/// The midpoint of a real ball rounded to a multiple of 10^exponent: first to 10^(exponent - 5), then half to even, so
/// that enclosures of one number round alike even where it lies half-way.
Decimal round_to_decimal(arb_srcptr ball, long exponent);

/// The least e with |z| (1 + 10^-digits) < 10^e for the larger part z of the midpoint: of a number next to a power of
/// ten the same for every enclosure that is accurate to more digits. The ball must be finite and not contain 0.
long decimal_magnitude(const ComplexBall& ball, long digits);

}  // namespace eliminant::bridge
