// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/parse_number.hpp>

#include <algorithm>
#include <string>

namespace eliminant::symbolic {

namespace {

// Not <cctype>: the grammar must not depend on the locale.
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hex_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool begins_hexadecimal(std::string_view text) {
  if (text.size() < 3 || text[0] != '0' || (text[1] != 'x' && text[1] != 'X')) return false;
  return is_hex_digit(text[2]) || (text[2] == '.' && text.size() > 3 && is_hex_digit(text[3]));
}

// The parts of a literal; `end` is its length.
struct Literal {
  std::string_view whole;
  std::string_view fraction;
  bool negative_exponent = false;
  std::string_view exponent;
  int base = 10;
  std::size_t end = 0;
};

Literal split_literal(std::string_view text) {
  Literal parts;
  const bool hexadecimal = begins_hexadecimal(text);
  const auto in_base = hexadecimal ? is_hex_digit : is_digit;
  std::size_t at = 0;
  const auto take_while = [&](auto accept) {
    const std::size_t begin = at;
    while (at < text.size() && accept(text[at])) ++at;
    return text.substr(begin, at - begin);
  };
  if (hexadecimal) {
    parts.base = 16;
    at = 2;
  }
  parts.whole = take_while(in_base);
  if (at < text.size() && text[at] == '.') {
    ++at;
    parts.fraction = take_while(in_base);
  }
  if (parts.whole.empty() && parts.fraction.empty()) return {};
  parts.end = at;

  const char lower = hexadecimal ? 'p' : 'e';
  const char upper = hexadecimal ? 'P' : 'E';
  if (at < text.size() && (text[at] == lower || text[at] == upper)) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) parts.negative_exponent = text[at++] == '-';
    parts.exponent = take_while(is_digit);
    if (!parts.exponent.empty()) parts.end = at;
  }
  return parts;
}

// The value of `digits`, or limit + 1 when it is larger than limit.
std::size_t value_up_to(std::string_view digits, std::size_t limit) {
  std::size_t value = 0;
  for (const char c : digits) {
    value = value * 10 + static_cast<std::size_t>(c - '0');
    if (value > limit) return limit + 1;
  }
  return value;
}

}  // namespace

std::size_t number_literal_length(std::string_view text) { return split_literal(text).end; }

Rational number_literal_value(std::string_view literal, const Limits& limits) {
  const Literal parts = split_literal(literal);
  const std::size_t digit_count = parts.whole.size() + parts.fraction.size();
  if (digit_count > limits.digits)
    throw LimitReached("a number has " + std::to_string(digit_count) + " digits, the limit is " +
                       std::to_string(limits.digits));
  const std::size_t exponent_limit = parts.base == 16 ? 3 * limits.decimal_exponent : limits.decimal_exponent;
  const std::size_t exponent = value_up_to(parts.exponent, exponent_limit);
  if (exponent > exponent_limit)
    throw LimitReached("a number has an exponent beyond the limit " + std::to_string(exponent_limit));

  const Integer digits = Integer::from_string(std::string(parts.whole) + std::string(parts.fraction), parts.base);
  if (digits.is_zero()) return Rational();
  // value = digits * radix^scale; a hexadecimal digit behind the point is worth four binary places.
  const long fraction_places = static_cast<long>(parts.fraction.size()) * (parts.base == 16 ? 4 : 1);
  const long signed_exponent = parts.negative_exponent ? -static_cast<long>(exponent) : static_cast<long>(exponent);
  const long scale = signed_exponent - fraction_places;
  const Integer radix(parts.base == 16 ? 2 : 10);
  const Integer factor = power(radix, static_cast<unsigned long>(scale < 0 ? -scale : scale));
  return scale < 0 ? Rational(digits, factor) : Rational(digits * factor);
}

Rational parse_number(std::string_view text, const Limits& limits, const Locate& locate) {
  const Locate place_of = locate ? locate : locate_in(text);
  std::size_t at = 0;
  const auto skip_blanks = [&] {
    while (at < text.size() && is_blank(text[at])) ++at;
  };
  const auto found = [&] {
    if (at == text.size()) return std::string("the end");
    // Cut at a character boundary: the message must stay valid UTF-8.
    std::size_t end = at + 1;
    while (end < text.size() && (end - at < 20 || (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)) ++end;
    return "'" + std::string(text.substr(at, end - at)) + "'";
  };
  const auto refuse = [&](const std::string& expected) {
    const bool empty = text.find_first_not_of(" \t\n\r") == std::string_view::npos;
    throw ParseError(empty ? "a number is empty" : "unexpected " + found() + " in a number", expected, place_of(at));
  };
  const auto signed_literal = [&](const char* expected) {
    skip_blanks();
    bool negative = false;
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) {
      negative = text[at] == '-';
      ++at;
      skip_blanks();
    }
    const std::size_t length = number_literal_length(text.substr(at));
    if (length == 0) refuse(expected);
    const Rational value =
        with_place(place_of, at, [&] { return number_literal_value(text.substr(at, length), limits); });
    at += length;
    skip_blanks();
    return negative ? -value : value;
  };

  Rational value = signed_literal("a number such as 12, -25/16, 0.1, 1e-3 or 0x1.8p-3");
  if (at < text.size() && text[at] == '/') {
    ++at;
    skip_blanks();
    const std::size_t denominator_at = at;
    const Rational denominator = signed_literal("a denominator");
    if (denominator.is_zero())
      throw ParseError("the denominator of a number is zero", "a non-zero denominator", place_of(denominator_at));
    value = value / denominator;
  }
  if (at != text.size()) refuse("the end of the number");
  return value;
}

}  // namespace eliminant::symbolic
