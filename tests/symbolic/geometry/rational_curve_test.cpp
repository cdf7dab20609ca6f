// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;

namespace {

UnivariatePolynomial univariate(const std::vector<long>& coefficients) {
  std::vector<Integer> integers;
  for (const long c : coefficients) integers.emplace_back(c);
  return UnivariatePolynomial(integers);
}

}  // namespace

TEST_CASE("RationalCurve: a common factor and common content are divided out") {
  // (2t^2 + 2t, 4t + 4, 2t + 2) = 2 (t + 1) (t, 2, 1).
  const RationalCurve line({univariate({0, 2, 2}), univariate({4, 4}), univariate({2, 2})});
  CHECK(line.dimension() == 2);
  CHECK(line.degree() == 1);
  CHECK(line.coordinates() == std::vector{univariate({0, 1}), univariate({2}), univariate({1})});
  CHECK(line.at_infinity() == std::vector<Integer>{1, 0, 0});
  CHECK(line.at(Rational(Integer(1), Integer(3))) == std::vector<Rational>{Rational(Integer(1), Integer(3)), 2, 1});
}

TEST_CASE("RationalCurve: zero coordinates, a point at infinity, a constant map") {
  const RationalCurve cubic({univariate({1}), univariate({0, 1}), univariate({0, 0, 1}), univariate({0, 0, 0, 1})});
  CHECK(cubic.dimension() == 3);
  CHECK(cubic.degree() == 3);
  CHECK(cubic.at_infinity() == std::vector<Integer>{0, 0, 0, 1});
  CHECK(cubic.at(0) == std::vector<Rational>{1, 0, 0, 0});
  const RationalCurve axis({univariate({}), univariate({0, -3}), univariate({3})});
  CHECK(axis.coordinates() == std::vector{univariate({}), univariate({0, -1}), univariate({1})});
  const RationalCurve point({univariate({0, 2}), univariate({0, 4}), univariate({0, 6})});
  CHECK(point.degree() == 0);
  CHECK(point.at_infinity() == std::vector<Integer>{1, 2, 3});
}

TEST_CASE("RationalCurve: three or four coordinates, not all zero") {
  CHECK_THROWS_AS(RationalCurve({univariate({1}), univariate({0, 1})}), InvalidInput);
  CHECK_THROWS_AS(RationalCurve(std::vector(5, univariate({1}))), InvalidInput);
  CHECK_THROWS_AS(RationalCurve(std::vector(3, univariate({}))), InvalidInput);
}

TEST_CASE("rational_curve: common denominators of rational coefficients are cleared") {
  const Rational half(Integer(1), Integer(2));
  const Rational third(Integer(1), Integer(3));
  const std::vector<UnivariatePolynomial> expected{univariate({0, 3}), univariate({2, 0, 6}), univariate({6})};
  CHECK(rational_curve(std::vector<std::vector<Rational>>{{0, half}, {third, 0, 1}, {1}}).coordinates() == expected);
  const Polynomial t = Polynomial::variable(1, 0);
  CHECK(rational_curve(std::vector{half * t, Polynomial::constant(1, third) + t * t, Polynomial::constant(1, 1)})
            .coordinates() == expected);
  CHECK_THROWS_AS(rational_curve(std::vector<Polynomial>(3, Polynomial::variable(2, 0))), InvalidInput);
}
