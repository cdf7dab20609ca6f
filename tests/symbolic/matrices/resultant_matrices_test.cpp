// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>
#include <eliminant/symbolic/matrices/bezout_matrix.hpp>
#include <eliminant/symbolic/matrices/hybrid_bezout_matrix.hpp>
#include <eliminant/symbolic/matrices/sylvester_matrix.hpp>
#include <support/curves.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;

namespace {

UnivariatePolynomial univariate(std::vector<long> coefficients) {
  std::vector<Integer> integers;
  for (const long c : coefficients) integers.emplace_back(c);
  return UnivariatePolynomial(integers);
}

/// Random polynomial of degree `eliminated` in y whose coefficients have degree <= hidden in x.
HiddenVariablePolynomial random_hidden(Random& random, long eliminated, long hidden) {
  HiddenVariablePolynomial f;
  for (long k = 0; k <= eliminated; ++k) {
    std::vector<long> coefficients;
    for (long i = 0; i <= hidden; ++i) coefficients.push_back(random.between(-9, 9));
    if (k == eliminated) coefficients.back() = random.nonzero(9);
    f.coefficients.push_back(univariate(coefficients));
  }
  return f;
}

}  // namespace

TEST_CASE("Sylvester matrix: the entries of a small example in the order of the paper") {
  // f = y^2 + x y - 2, g = 3 y + x^2, x hidden.
  const PolynomialMatrix s =
      sylvester_matrix(hide_variable(curve("y^2 + x*y - 2"), 0), hide_variable(curve("3y + x^2"), 0));
  REQUIRE(s.rows() == 3);
  CHECK(s.entry(0, 0) == univariate({-2}));
  CHECK(s.entry(1, 0) == univariate({0, 1}));
  CHECK(s.entry(2, 0) == univariate({1}));
  CHECK(s.entry(0, 1) == univariate({0, 0, 1}));
  CHECK(s.entry(1, 1) == univariate({3}));
  CHECK(s.entry(2, 2) == univariate({3}));
  CHECK(s.entry(0, 2).is_zero());
  // (-1)^(mn) Res(f, g) = 9 f(-x^2 / 3) = x^4 - 3 x^3 - 18.
  CHECK(determinant(s) == univariate({-18, 0, 0, -3, 1}));
}

TEST_CASE("Sylvester matrix: (1, y, ..., y^(m+n-1)) is in the left kernel at a common zero") {
  const HiddenVariablePolynomial f = hide_variable(curve("(y-2)*(y+x)"), 0);
  const HiddenVariablePolynomial g = hide_variable(curve("(y-2)*(y^2+1) + (x-3)*y"), 0);
  const PolynomialMatrix s = sylvester_matrix(f, g);
  for (long column = 0; column < s.columns(); ++column) {
    Integer sum;
    for (long row = 0; row < s.rows(); ++row) {
      Integer value;
      fmpz_poly_evaluate_fmpz(value.get(), s.entry(row, column).get(), Integer(3).get());
      sum = sum + value * power(Integer(2), static_cast<unsigned long>(row));
    }
    CHECK(sum.is_zero());
  }
}

TEST_CASE("Bezout matrix: symmetric, and times (u - v) the numerator of its definition") {
  Random random(11);
  for (int trial = 0; trial < 20; ++trial) {
    const HiddenVariablePolynomial f = random_hidden(random, random.between(1, 5), 2);
    const HiddenVariablePolynomial g = random_hidden(random, random.between(1, 5), 2);
    const PolynomialMatrix b = bezout_matrix(f, g);
    const long size = b.rows();
    REQUIRE(size == std::max(f.degree(), g.degree()));
    const auto at = [](const HiddenVariablePolynomial& p, long k) {
      return k <= p.degree() ? p.coefficients[static_cast<std::size_t>(k)] : UnivariatePolynomial();
    };
    const auto theta = [&](long i, long j) {
      return i < 0 || j < 0 || i >= size || j >= size ? UnivariatePolynomial() : b.entry(i, j);
    };
    for (long i = 0; i <= size; ++i)
      for (long j = 0; j <= size; ++j) {
        // Coefficient of u^i v^j of (u - v) * sum theta_ij u^i v^j and of f(u) g(v) - g(u) f(v).
        CHECK(theta(i - 1, j) - theta(i, j - 1) == at(f, i) * at(g, j) - at(g, i) * at(f, j));
        CHECK(theta(i, j) == theta(j, i));
      }
  }
}

TEST_CASE("Bezout matrix: its determinant is the Sylvester determinant with the corrected sign of Proposition 3") {
  Random random(12);
  for (long m = 1; m <= 5; ++m)
    for (long n = m; n <= 5; ++n) {
      CAPTURE(m);
      CAPTURE(n);
      const HiddenVariablePolynomial f = random_hidden(random, m, 2);
      const HiddenVariablePolynomial g = random_hidden(random, n, 2);
      UnivariatePolynomial expected =
          determinant(sylvester_matrix(f, g)) * power(g.leading_coefficient(), static_cast<unsigned long>(n - m));
      if ((n * (n + 1) / 2) % 2 != 0) expected = UnivariatePolynomial() - expected;
      CHECK(determinant(bezout_matrix(f, g)) == expected);
    }
}

TEST_CASE("Resultant: equals the determinant of the Sylvester matrix in either hidden variable") {
  Random random(13);
  for (int trial = 0; trial < 30; ++trial) {
    const Polynomial p = random_dense(random, static_cast<unsigned long>(random.between(1, 5)), 20);
    const Polynomial q = random_dense(random, static_cast<unsigned long>(random.between(1, 5)), 20);
    CAPTURE(text(p));
    CAPTURE(text(q));
    for (std::size_t hidden : {0U, 1U}) {
      const HiddenVariablePolynomial f = hide_variable(p, hidden);
      const HiddenVariablePolynomial g = hide_variable(q, hidden);
      if (f.degree() < 0 || g.degree() < 0) continue;
      CHECK(resultant(f, g, static_cast<std::uint64_t>(trial)) == determinant(sylvester_matrix(f, g)));
    }
  }
}

TEST_CASE("Resultant: zero exactly for a common factor, and right where leading coefficients vanish") {
  const auto res = [](const char* p, const char* q) {
    return resultant(hide_variable(curve(p), 0), hide_variable(curve(q), 0));
  };
  CHECK(res("(x-y)*(x+1)*y", "(x-y)*y^2").is_zero());
  CHECK(res("x*y - 1", "x*y + 1") == univariate({0, -2}));  // both leading coefficients vanish at 0
  CHECK(res("x", "y^2 + 1") == univariate({0, 0, 1}));      // no y in one of them
}

TEST_CASE("Change of variables: shear and scaling are exact and inverse to themselves with opposite parameters") {
  Random random(14);
  const Polynomial p = random_dense(random, 4, 50);
  CHECK(shear(curve("x^2 + y"), Rational(3)) == curve("(x - 3*y)^2 + y"));
  CHECK(shear(shear(p, Rational(7)), Rational(-7)) == p);
  CHECK(scale_by_powers_of_two(curve("x^2*y + 3"), 2, -5) == curve("x^2*y/2 + 3"));
  CHECK(scale_by_powers_of_two(scale_by_powers_of_two(p, 900, -900), -900, 900) == p);
  CHECK(exchange_variables(curve("x^3 - 2*y")) == curve("y^3 - 2*x"));
}

TEST_CASE("Hybrid Bezout matrix: its rows are polynomials of the ideal, its determinant the resultant up to sign") {
  Random random(15);
  for (int trial = 0; trial < 20; ++trial) {
    const auto m = static_cast<unsigned long>(random.between(1, 5));
    const auto n = static_cast<unsigned long>(random.between(1, static_cast<long>(m)));
    const Polynomial p = random_dense(random, m, 9) + power(Polynomial::variable(2, 1), m);
    const Polynomial q = random_dense(random, n, 9) + power(Polynomial::variable(2, 1), n);
    const HiddenVariablePolynomial f = hide_variable(p, 0);
    const HiddenVariablePolynomial g = hide_variable(q, 0);
    if (f.degree() != static_cast<long>(m) || g.degree() != static_cast<long>(n)) continue;
    CAPTURE(text(p));
    CAPTURE(text(q));
    const PolynomialMatrix hybrid = hybrid_bezout_matrix(f, g, f.degree(), g.degree());
    REQUIRE(hybrid.rows() == f.degree());
    for (long row = 0; row < hybrid.rows(); ++row) {
      const long degree = row < g.degree() ? f.degree() + row : row;
      for (long j = 0; j < hybrid.columns(); ++j) CHECK(hybrid.entry(row, j).degree() <= std::max(-1L, degree - j));
    }
    const UnivariatePolynomial expected = resultant(f, g);
    const UnivariatePolynomial found = determinant(hybrid);
    CHECK((found == expected || found == UnivariatePolynomial() - expected));
  }
  CHECK_THROWS_AS(hybrid_bezout_matrix(hide_variable(curve("y"), 0), hide_variable(curve("y^2"), 0), 1, 2),
                  InvalidInput);
}
