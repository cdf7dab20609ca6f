// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/symbolic/arithmetic/integer_relation.hpp>

using namespace eliminant::symbolic;

namespace {

/// The integer part of 10^60 times the square root of two to these powers.
std::vector<Integer> powers_of_root() {
  return {Integer::from_string("1000000000000000000000000000000000000000000000000000000000000"),
          Integer::from_string("1414213562373095048801688724209698078569671875376948073176679"),
          Integer::from_string("2000000000000000000000000000000000000000000000000000000000000")};
}

}  // namespace

TEST_CASE("Integer relation: the minimal polynomial of the square root of two") {
  const std::vector<Integer> relation = integer_relation(powers_of_root());
  REQUIRE(relation.size() == 3);
  // 2 - x^2 up to the sign.
  CHECK(relation[1].is_zero());
  CHECK(relation[0] + Integer(2) * relation[2] == Integer(0));
  CHECK((relation[2] == Integer(1) || relation[2] == Integer(-1)));
}

TEST_CASE("Integer relation: of unrelated numbers it has many digits") {
  const std::vector<Integer> numbers{powers_of_root()[0], powers_of_root()[1]};
  for (const Integer& coefficient : integer_relation(numbers)) CHECK(coefficient.bit_length() > 90);
}
