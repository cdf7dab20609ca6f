// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/integer.hpp>
#include <string>

using namespace eliminant;
using namespace eliminant::symbolic;

TEST_CASE("Integer: text of any length is read back") {
  const std::string digits = "-1" + std::string(200, '0') + "7";
  CHECK(Integer::from_string(digits).to_string() == digits);
  CHECK(Integer::from_string("+12") == Integer(12));
  CHECK(Integer::from_string("ff", 16) == Integer(255));
  CHECK_THROWS_AS(Integer::from_string(""), InvalidInput);
  CHECK_THROWS_AS(Integer::from_string("1x"), InvalidInput);
}

TEST_CASE("Integer: arithmetic beyond a machine word") {
  const Integer big = power(Integer(2), 100);
  CHECK(big.bit_length() == 101);
  CHECK((big * big).to_string() == "1606938044258990275541962092341162602522202993782792835301376");
  CHECK((big - big).is_zero());
  CHECK((-big).sign() == -1);
  CHECK(big + Integer(-1) == power(Integer(2), 100) - Integer(1));
}

TEST_CASE("Integer: a copy is independent, a moved-from value can be assigned") {
  Integer a = power(Integer(10), 50);
  Integer b = a;
  b = b + Integer(1);
  CHECK_FALSE(a == b);
  const Integer c = std::move(a);
  a = Integer(3);
  CHECK(a == Integer(3));
  CHECK(c == power(Integer(10), 50));
}
