// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/geometry/image_dimension.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;

namespace {

std::vector<Polynomial> polynomials(const std::vector<std::string>& names, const std::array<std::string, 4>& texts) {
  std::vector<Polynomial> result;
  for (const std::string& text : texts) result.push_back(parse_polynomial(text, names));
  return result;
}

RationalSurface triangular(const std::array<std::string, 4>& texts) {
  return {RationalSurface::Kind::triangular, polynomials({"s", "t", "u"}, texts)};
}

RationalSurface tensor(const std::array<std::string, 4>& texts) {
  return {RationalSurface::Kind::tensor_product, polynomials({"s", "t"}, texts)};
}

}  // namespace

TEST_CASE("RationalSurface: the sphere as forms of degree 2") {
  const RationalSurface sphere = triangular({"s^2+t^2+u^2", "2*s*u", "2*s*t", "s^2-t^2-u^2"});
  CHECK(sphere.degree() == 2);
  CHECK(sphere.at({1, 2, 3}) == std::vector<Rational>{14, 6, 4, -12});
  CHECK_THROWS_AS(sphere.at({1, 2}), InvalidInput);
}

TEST_CASE("RationalSurface: common factors and content are divided out, degrees are those that remain") {
  const RationalSurface plane = triangular({"(s+t)*s/2", "(s+t)*t/3", "0", "(s+t)*u/6"});
  CHECK(plane.degree() == 1);
  CHECK(plane.coordinates() == polynomials({"s", "t", "u"}, {"3*s", "2*t", "0", "u"}));
  const RationalSurface saddle = tensor({"4*(t^2+1)*s", "4*(t^2+1)*t", "6*(t^2+1)*s*t", "2*t^2+2"});
  CHECK(saddle.bidegree() == std::array<long, 2>{1, 1});
  CHECK(saddle.coordinates() == polynomials({"s", "t"}, {"2*s", "2*t", "3*s*t", "1"}));
  CHECK(tensor({"s^3", "t", "s*t^2", "1"}).bidegree() == std::array<long, 2>{3, 2});
}

TEST_CASE("RationalSurface: what is no surface map is refused") {
  CHECK_THROWS_AS(triangular({"0", "0", "0", "0"}), InvalidInput);
  CHECK_THROWS_AS(tensor({"0", "0", "0", "0"}), InvalidInput);
  CHECK_THROWS_AS(triangular({"s", "t", "u", "1"}), InvalidInput);
  CHECK_THROWS_AS(triangular({"s^2 + t", "t^2", "u^2", "s*t"}), InvalidInput);
  const Polynomial s = Polynomial::variable(2, 0);
  CHECK_THROWS_AS(RationalSurface(RationalSurface::Kind::tensor_product, {s, s, s}), InvalidInput);
  CHECK_THROWS_AS(RationalSurface(RationalSurface::Kind::triangular, {s, s, s, s}), InvalidInput);
}

TEST_CASE("is_two_dimensional: a map that depends on one combination of its parameters is no surface") {
  CHECK(is_two_dimensional(tensor({"s", "t", "s*t", "1"})));
  CHECK(is_two_dimensional(triangular({"s^2+t^2+u^2", "2*s*u", "2*s*t", "s^2-t^2-u^2"})));
  CHECK(is_two_dimensional(tensor({"s^2", "t^2", "s*t", "1"})));
  CHECK(is_two_dimensional(tensor({"s", "t", "1", "0"})));
  CHECK_FALSE(is_two_dimensional(tensor({"s+t", "(s+t)^2", "(s+t)^3", "1"})));
  CHECK_FALSE(is_two_dimensional(tensor({"s", "s^2", "0", "s+1"})));
  CHECK_FALSE(is_two_dimensional(tensor({"1", "2", "3", "4"})));
  CHECK_FALSE(is_two_dimensional(triangular({"s^2", "s*t", "t^2", "s^2+t^2"})));
  CHECK_FALSE(is_two_dimensional(triangular({"(s+u)^2", "(s+u)*t", "t^2", "0"})));
  // Rank 3 away from the first points that are tried.
  CHECK(is_two_dimensional(tensor({"(s-2)*(s+3)*(s-7)*s", "(s-2)*(s+3)*(s-7)*t", "(s-2)^2*(s+3)^2*(s-7)^2", "1"})));
}
