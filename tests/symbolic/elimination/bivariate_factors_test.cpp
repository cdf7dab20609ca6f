// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/bivariate_factors.hpp>
#include <support/curves.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;

TEST_CASE("bivariate factors: contents first, with multiplicities") {
  const Polynomial p = Rational(-6) * curve("(x^2 + 1)^2*(y - 3)*(x*y - 1)^3*(x^2 - 2y^2)");
  const std::vector<BivariateFactor> factors = bivariate_factors(p, 0);
  REQUIRE(factors.size() == 4);
  CHECK(text(factors[0].factor) == "x^2 + 1");
  CHECK(factors[0].multiplicity == 2);
  CHECK(text(factors[1].factor) == "y - 3");
  Polynomial product = Polynomial::constant(2, 1);
  for (const BivariateFactor& factor : factors) product = product * power(factor.factor, factor.multiplicity);
  CHECK(product.primitive_part() == p.primitive_part());
}

TEST_CASE("bivariate factors: irreducible over Q where every prime splits it") {
  CHECK(bivariate_factors(curve("x^4 + y^4"), 0).size() == 1);
  CHECK(bivariate_factors(curve("x^4 - 10x^2*y^2 + y^4"), 0).size() == 1);
  CHECK(bivariate_factors(curve("x^4 - 10x^2*y^2 + 9y^4"), 0).size() == 4);
}

TEST_CASE("bivariate factors: products of random polynomials come apart, random ones are irreducible") {
  Random random(41);
  for (int trial = 0; trial < 5; ++trial) {
    const Polynomial p = random_dense(random, 5, 99);
    const Polynomial q = random_dense(random, 3, 99);
    CHECK(bivariate_factors(p, 0).size() == 1);
    CHECK(bivariate_factors(p * q, 0).size() == 2);
  }
}

TEST_CASE("bivariate factors: constants have none, zero and other rings are refused") {
  CHECK(bivariate_factors(curve("7"), 0).empty());
  CHECK_THROWS_AS(bivariate_factors(Polynomial(2), 0), InvalidInput);
  CHECK_THROWS_AS(bivariate_factors(Polynomial::variable(3, 0), 0), InvalidInput);
}
