// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::symbolic {

Rational::Rational(const Integer& numerator, const Integer& denominator) : Rational() {
  if (denominator.is_zero())
    throw InvalidInput("the denominator of a rational number is zero", "a non-zero denominator");
  fmpq_set_fmpz_frac(value_, numerator.get(), denominator.get());
}

Rational operator/(const Rational& a, const Rational& b) {
  if (b.is_zero()) throw InvalidInput("division by zero", "a non-zero divisor");
  Rational quotient;
  fmpq_div(quotient.value_, a.value_, b.value_);
  return quotient;
}

std::string Rational::to_string() const {
  std::string text = numerator().to_string();
  if (!is_integer()) text += "/" + denominator().to_string();
  return text;
}

}  // namespace eliminant::symbolic
