// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <string>
#include <utility>
#include <vector>

using namespace eliminant;
using namespace eliminant::symbolic;

TEST_CASE("parse_number: every notation has its exact value") {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"12", "12"},
      {"-25/16", "-25/16"},
      {"0.1", "1/10"},
      {"1e-3", "1/1000"},
      {"2e3", "2000"},
      {"1.5E+2", "150"},
      {".5", "1/2"},
      {"5.", "5"},
      {"0x1.8p-3", "3/16"},
      {"0X10", "16"},
      {"0x.8", "1/2"},
      {"-0x1p+4", "-16"},
      {" + 3 / 6 ", "1/2"},
      {"1e2/1e-2", "10000"},
      {"0e999999", "0"},
      {"-0", "0"},
      {"0.30000000000000004", "7500000000000001/25000000000000000"},
      {"007", "7"},
      {"0.1/0.3", "1/3"},
      {"-1/-2", "1/2"}};
  for (const auto& [written, value] : cases) {
    const std::string text = written;
    CAPTURE(text);
    CHECK(parse_number(text).to_string() == value);
  }
}

TEST_CASE("parse_number: 1e400 and a 400-digit integer keep every digit") {
  CHECK(parse_number("1e400") == Rational(power(Integer(10), 400)));
  CHECK(parse_number("1e-400") == Rational(1) / Rational(power(Integer(10), 400)));
  const std::string digits(400, '7');
  CHECK(parse_number(digits).to_string() == digits);
}

TEST_CASE("parse_number: what is no number is refused at its place") {
  const std::vector<std::pair<const char*, std::size_t>> cases{
      {"", 1},   {"abc", 1}, {"1,5", 2}, {"1/0", 3},   {"1/", 3}, {"1 2", 3},   {"--1", 2},
      {"1e", 2}, {"nan", 1}, {"inf", 1}, {"1/2/3", 4}, {"0x", 2}, {"1.2.3", 4}, {".", 1}};
  for (const auto& [written, column] : cases) {
    const std::string text = written;
    CAPTURE(text);
    try {
      parse_number(text);
      FAIL("accepted");
    } catch (const ParseError& error) {
      CHECK(error.place().line == 1);
      CHECK(error.place().column == column);
      CHECK_FALSE(error.expected().empty());
    }
  }
}

TEST_CASE("parse_number: an empty number is called so") {
  for (const char* text : {"", " ", " \t\n"}) CHECK_THROWS_WITH_AS(parse_number(text), "a number is empty", ParseError);
  CHECK_THROWS_WITH_AS(parse_number("1/"), "unexpected the end in a number", ParseError);
}

TEST_CASE("parse_number: the limits are reached exactly where they say") {
  CHECK(parse_number(std::string(1'000'000, '9')).numerator().bit_length() == 3321929);
  CHECK_THROWS_AS(parse_number(std::string(1'000'001, '9')), LimitReached);
  CHECK_NOTHROW(parse_number("1e1000000"));
  CHECK_NOTHROW(parse_number("1e-1000000"));
  CHECK_THROWS_AS(parse_number("1e1000001"), LimitReached);
  CHECK_THROWS_AS(parse_number("1e-1000001"), LimitReached);
  CHECK_THROWS_AS(parse_number("1e99999999999999999999999999"), LimitReached);
  CHECK_NOTHROW(parse_number("0x1p3000000"));
  CHECK_THROWS_AS(parse_number("0x1p3000001"), LimitReached);
}

TEST_CASE("number_literal_length: letters that no digit follows stay outside") {
  CHECK(number_literal_length("2e") == 1);
  CHECK(number_literal_length("2e-x") == 1);
  CHECK(number_literal_length("2e3x") == 3);
  CHECK(number_literal_length("0x") == 1);
  CHECK(number_literal_length("0x1p") == 3);
  CHECK(number_literal_length("x") == 0);
}
