// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <eliminant/bridge/enclosures/decimal.hpp>

namespace eliminant::bridge {

namespace {

constexpr long guard_digits = 5;

/// 10^exponent as a ball.
RealBall power_of_ten(long exponent, long precision_bits) {
  RealBall result;
  arb_set_ui(result.get(), 10);
  arb_t power;
  arb_init(power);
  arb_set_si(power, exponent);
  arb_pow(result.get(), result.get(), power, precision_bits);
  arb_clear(power);
  return result;
}

}  // namespace

symbolic::Rational Decimal::to_rational() const {
  const symbolic::Integer scale =
      symbolic::power(symbolic::Integer(10), static_cast<unsigned long>(std::labs(exponent)));
  return exponent >= 0 ? symbolic::Rational(value * scale) : symbolic::Rational(value, scale);
}

std::string Decimal::to_string() const {
  if (value.is_zero()) return "0";
  std::string digits = value.to_string();
  const bool negative = digits.front() == '-';
  if (negative) digits.erase(0, 1);
  long last = exponent;  // power of ten of the last digit
  while (digits.size() > 1 && digits.back() == '0') {
    digits.pop_back();
    ++last;
  }
  const auto length = static_cast<long>(digits.size());
  const long point = length + last;  // digits before the decimal point
  std::string text;
  if (last >= 0 && point <= 21) {
    text = digits + std::string(static_cast<std::size_t>(last), '0');
  } else if (last < 0 && point > 0) {
    text = digits.substr(0, static_cast<std::size_t>(point)) + "." + digits.substr(static_cast<std::size_t>(point));
  } else if (last < 0 && point > -6) {
    text = "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  } else {
    text = digits.substr(0, 1);
    if (length > 1) text += "." + digits.substr(1);
    text += "e" + std::to_string(point - 1);
  }
  return negative ? "-" + text : text;
}

std::string exact_text(const symbolic::Rational& value) {
  symbolic::Integer rest = value.denominator();
  const auto remove = [&](long prime) {
    return static_cast<long>(fmpz_remove(rest.get(), rest.get(), symbolic::Integer(prime).get()));
  };
  const long digits = std::max(remove(2), remove(5));
  if (!(rest == symbolic::Integer(1))) return value.to_string();
  const symbolic::Rational scaled =
      value * symbolic::Rational(symbolic::power(symbolic::Integer(10), static_cast<unsigned long>(digits)));
  return Decimal{scaled.numerator(), -digits}.to_string();
}

Decimal round_to_decimal(arb_srcptr ball, long exponent) {
  const long fine = exponent - guard_digits;
  const long bits = std::max(0L, static_cast<long>(arf_abs_bound_lt_2exp_si(arb_midref(ball)))) +
                    static_cast<long>(std::ceil(static_cast<double>(std::labs(fine)) * 3.33)) + 64;
  RealBall scaled;
  const RealBall scale = power_of_ten(-fine, bits);
  arb_set_arf(scaled.get(), arb_midref(ball));
  arb_mul(scaled.get(), scaled.get(), scale.get(), bits);
  Decimal result;
  result.exponent = exponent;
  arf_get_fmpz(result.value.get(), arb_midref(scaled.get()), ARF_RND_NEAR);
  // Half to even on the guard digits.
  const symbolic::Integer unit = symbolic::power(symbolic::Integer(10), guard_digits);
  symbolic::Integer quotient;
  symbolic::Integer remainder;
  fmpz_fdiv_qr(quotient.get(), remainder.get(), result.value.get(), unit.get());
  fmpz_mul_ui(remainder.get(), remainder.get(), 2);
  const int against_half = fmpz_cmp(remainder.get(), unit.get());
  if (against_half > 0 || (against_half == 0 && fmpz_is_odd(quotient.get())))
    fmpz_add_ui(quotient.get(), quotient.get(), 1);
  result.value = quotient;
  return result;
}

long decimal_magnitude(const ComplexBall& ball, long digits) {
  const arb_srcptr larger =
      arf_cmpabs(arb_midref(ball.real()), arb_midref(ball.imaginary())) >= 0 ? ball.real() : ball.imaginary();
  const long precision_bits = 4 * digits + 64;
  RealBall magnitude;
  arb_get_mid_arb(magnitude.get(), larger);
  arb_abs(magnitude.get(), magnitude.get());
  const RealBall margin = power_of_ten(-digits, precision_bits);
  arb_addmul(magnitude.get(), magnitude.get(), margin.get(), precision_bits);
  RealBall logarithm;
  arb_log_base_ui(logarithm.get(), magnitude.get(), 10, precision_bits);
  symbolic::Integer floor;
  arf_get_fmpz(floor.get(), arb_midref(logarithm.get()), ARF_RND_FLOOR);
  return fmpz_get_si(floor.get()) + 1;
}

}  // namespace eliminant::bridge
