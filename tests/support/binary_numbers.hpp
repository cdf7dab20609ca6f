// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <eliminant/symbolic/arithmetic/rational.hpp>

/// Binary fractions as rational numbers and as doubles.
namespace eliminant::test {

/// The number that a finite double is.
inline symbolic::Rational exact_rational(double number) {
  constexpr int digits_of_double = 53;
  int exponent = 0;
  const double digits = std::frexp(number, &exponent);
  const symbolic::Rational whole(static_cast<long>(std::ldexp(digits, digits_of_double)));
  exponent -= digits_of_double;
  const symbolic::Integer scale = symbolic::power(symbolic::Integer(2), static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? whole / symbolic::Rational(scale) : whole * symbolic::Rational(scale);
}

/// The double that is this number. Throws std::logic_error where none is.
inline double exact_double(const symbolic::Rational& number) {
  constexpr unsigned long digits_of_double = 53;
  symbolic::Integer odd = number.numerator();
  const symbolic::Integer denominator = number.denominator();
  const auto shift = odd.is_zero() ? 0 : fmpz_val2(odd.get());
  fmpz_tdiv_q_2exp(odd.get(), odd.get(), shift);
  const auto below = fmpz_val2(denominator.get());
  if (odd.bit_length() > digits_of_double || denominator.bit_length() != below + 1)
    throw std::logic_error("a control point is no double: " + number.to_string());
  return std::ldexp(fmpz_get_d(odd.get()), static_cast<int>(shift) - static_cast<int>(below));
}

}  // namespace eliminant::test
