// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/polynomial_tokens.hpp>

#include <string>

#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <eliminant/symbolic/arithmetic/variable_names.hpp>

namespace eliminant::symbolic {

void PolynomialTokens::advance() {
  using Kind = PolynomialToken::Kind;
  at_ = current_.offset + current_.text.size();
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r'))
    ++at_;
  const auto take = [&](Kind kind, std::size_t length) { current_ = {kind, at_, text_.substr(at_, length)}; };
  const std::string_view rest = text_.substr(at_);
  if (rest.empty()) return take(Kind::end, 0);
  if (const std::size_t length = number_literal_length(rest); length > 0) return take(Kind::number, length);
  if (const std::size_t length = identifier_length(rest); length > 0) return take(Kind::name, length);
  switch (rest.front()) {
    case '+':
      return take(Kind::plus, 1);
    case '-':
      return take(Kind::minus, 1);
    case '*':
      return rest.size() > 1 && rest[1] == '*' ? take(Kind::power, 2) : take(Kind::times, 1);
    case '/':
      return take(Kind::divide, 1);
    case '^':
      return take(Kind::power, 1);
    case '(':
      return take(Kind::open, 1);
    case ')':
      return take(Kind::close, 1);
    default:
      refuse_character();
  }
}

void PolynomialTokens::refuse_character() const {
  std::size_t end = at_ + 1;
  while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
  const std::string found(text_.substr(at_, end - at_));
  std::string expected = "a number, a variable, or one of + - * / ^ ( )";
  if (found == "=") expected = "a polynomial; write left side minus right side of an equation";
  if (found == "\u2212" || found == "\u2013") expected = "the ASCII minus sign -";
  if (found == "\u00B7" || found == "\u00D7" || found == "\u22C5") expected = "the ASCII multiplication sign *";
  if (found == "\u00B2" || found == "\u00B3") expected = "an exponent written with ^, such as x^2";
  if (found == ",") expected += " (the decimal sign is a point)";
  if (found == "[" || found == "{") expected += " (only round parentheses)";
  const bool printable = static_cast<unsigned char>(found.front()) >= 0x20;
  throw ParseError(printable ? "unexpected '" + found + "'" : "unexpected control character", expected, locate_(at_));
}

}  // namespace eliminant::symbolic
