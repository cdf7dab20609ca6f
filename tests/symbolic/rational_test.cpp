// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;

TEST_CASE("Rational: lowest terms with positive denominator") {
  const Rational value(Integer(6), Integer(-4));
  CHECK(value.to_string() == "-3/2");
  CHECK(value.numerator() == Integer(-3));
  CHECK(value.denominator() == Integer(2));
  CHECK(Rational(Integer(8), Integer(4)).is_integer());
}

TEST_CASE("Rational: field operations are exact") {
  const Rational tenth(Integer(1), Integer(10));
  const Rational fifth(Integer(1), Integer(5));
  CHECK(tenth + fifth == Rational(Integer(3), Integer(10)));
  CHECK(tenth - tenth == Rational());
  CHECK(tenth * Rational(10) == Rational(1));
  CHECK(tenth / fifth == Rational(Integer(1), Integer(2)));
  CHECK(tenth < fifth);
  CHECK((-tenth).sign() == -1);
}

TEST_CASE("Rational: division by zero is an error") {
  CHECK_THROWS_AS(Rational(Integer(1), Integer()), InvalidInput);
  CHECK_THROWS_AS(Rational(1) / Rational(), InvalidInput);
}
