// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <vector>

using namespace eliminant;
using namespace eliminant::symbolic;

namespace {

const Polynomial x = Polynomial::variable(2, 0);
const Polynomial y = Polynomial::variable(2, 1);
const Polynomial one = Polynomial::constant(2, 1);
const std::array<std::string, 2> names{"x", "y"};

}  // namespace

TEST_CASE("Polynomial: from_terms adds repeated monomials and drops zeros") {
  const std::vector<Polynomial::Term> terms{{2, {1, 0}}, {3, {1, 0}}, {1, {0, 1}}, {-1, {0, 1}}, {Rational(), {5, 5}}};
  CHECK(Polynomial::from_terms(2, terms) == Rational(5) * x);
}

TEST_CASE("Polynomial: degrees, also of the zero polynomial") {
  const Polynomial p = x * x * y + y + one;
  CHECK(p.total_degree() == 3);
  CHECK(p.degree(0) == 2);
  CHECK(p.degree(1) == 1);
  CHECK(p.term_count() == 3);
  CHECK(Polynomial(2).total_degree() == -1);
  CHECK(Polynomial(2).degree(0) == -1);
  CHECK(Polynomial(2).is_zero());
}

TEST_CASE("Polynomial: ring laws and powers") {
  CHECK((x + y) * (x - y) == x * x - y * y);
  CHECK(power(x + y, 3) == x * x * x + Rational(3) * x * x * y + Rational(3) * x * y * y + y * y * y);
  CHECK(power(x + y, 0) == one);
}

TEST_CASE("Polynomial: derivative, composition, primitive part, quotient") {
  CHECK((x * x * y).derivative(0) == Rational(2) * x * y);
  const std::array<Polynomial, 2> shear{x + y, y};
  CHECK((x * x).compose(shear) == power(x + y, 2));
  CHECK((Rational(Integer(-2), Integer(3)) * x - Rational(4) * y).primitive_part() == x + Rational(6) * y);
  CHECK(exact_quotient(x * x - y * y, x - y) == x + y);
  CHECK_THROWS_AS(exact_quotient(x, y), InvalidInput);
  CHECK_THROWS_AS(exact_quotient(x, Polynomial(2)), InvalidInput);
}

TEST_CASE("Polynomial: operands of different rings are refused") {
  CHECK_THROWS_AS(x + Polynomial::variable(3, 0), InvalidInput);
  CHECK_THROWS_AS(x * Polynomial::variable(1, 0), InvalidInput);
}

TEST_CASE("Polynomial: printed by decreasing total degree") {
  CHECK(to_string(one + x + x * y * y - Rational(Integer(1), Integer(2)) * x * x, names) == "x*y^2 - 1/2*x^2 + x + 1");
  CHECK(to_string(Polynomial(2), names) == "0");
  CHECK(to_string(-Rational(1) * x, names) == "-x");
}

TEST_CASE("Polynomial: copies are independent, also across rings") {
  Polynomial p = x;
  Polynomial q = p;
  q = q + one;
  CHECK(p == x);
  p = Polynomial::variable(3, 2);
  CHECK(p.variable_count() == 3);
  Polynomial moved = std::move(q);
  CHECK(moved == x + one);
}
