// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>
#include <support/curves.hpp>
#include <support/homogeneous_points.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;

namespace {

std::vector<Polynomial> polynomials(const std::vector<std::string>& names, const std::vector<std::string>& texts) {
  std::vector<Polynomial> result;
  for (const std::string& text : texts) result.push_back(parse_polynomial(text, names));
  return result;
}

Rational ratio(long a, long b) { return {Integer(a), Integer(b)}; }

// The point of a Bezier curve by repeated interpolation, v the fraction of the domain.
ControlPoint de_casteljau(std::vector<ControlPoint> points, const Rational& v) {
  for (std::size_t length = points.size(); length > 1; --length)
    for (std::size_t i = 0; i + 1 < length; ++i)
      for (std::size_t c = 0; c < points[i].size(); ++c)
        points[i][c] = (Rational(1) - v) * points[i][c] + v * points[i + 1][c];
  return points.front();
}

}  // namespace

TEST_CASE("power_coefficients: on the unit interval and on another one") {
  CHECK(power_coefficients({1, 1, 0}, {0, 1}) == std::vector<Rational>{1, 0, -1});
  // (t - 2) / 3, and its square.
  CHECK(power_coefficients({0, 1}, {2, 5}) == std::vector<Rational>{ratio(-2, 3), ratio(1, 3)});
  CHECK(power_coefficients({0, 0, 1}, {2, 5}) == std::vector<Rational>{ratio(4, 9), ratio(-4, 9), ratio(1, 9)});
  CHECK(power_coefficients({7}, {2, 5}) == std::vector<Rational>{7});
  CHECK_THROWS_AS(power_coefficients({}, {0, 1}), InvalidInput);
  CHECK_THROWS_AS(power_coefficients({1, 2}, {1, 1}), InvalidInput);
}

TEST_CASE("bezier_curve: the quarter circle is (1 - t^2 : 2t : 1 + t^2)") {
  const CurvePiece quarter = bezier_curve({{1, 0, 1}, {1, 1, 1}, {0, 2, 2}});
  CHECK(quarter.map.coordinates() == rational_curve(polynomials({"t"}, {"1-t^2", "2*t", "1+t^2"})).coordinates());
  CHECK(*quarter.domain == Interval{0, 1});
}

TEST_CASE("bezier_curve: a raised degree is reduced to the true one") {
  // The segment from (1, 2) to (4, 8) in degree 3, and with a common factor 1 + t of all coordinates.
  const CurvePiece raised = bezier_curve({{1, 2, 1}, {2, 4, 1}, {3, 6, 1}, {4, 8, 1}});
  CHECK(raised.map.degree() == 1);
  CHECK(raised.map.coordinates() == rational_curve(polynomials({"t"}, {"1+3*t", "2+6*t", "1"})).coordinates());
  const CurvePiece multiplied = bezier_curve({{1, 2, 1}, {3, 6, ratio(3, 2)}, {8, 16, 2}});
  CHECK(multiplied.map.coordinates() == raised.map.coordinates());
}

TEST_CASE("bezier_curve: on any domain the same points as de Casteljau's algorithm") {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    const std::size_t dimension = random.next() % 2 == 0 ? 3 : 4;
    std::vector<ControlPoint> points(1 + random.next() % 7);
    for (ControlPoint& point : points)
      for (std::size_t c = 0; c < dimension; ++c) point.push_back(ratio(random.between(-9, 9), random.between(1, 4)));
    points.front()[0] = 1;
    const Interval domain{ratio(random.between(-9, 0), 3), ratio(random.between(1, 9), 2)};
    const CurvePiece piece = bezier_curve(points, domain);
    for (long k = -2; k <= 6; ++k) {
      const Rational v = ratio(k, 4);
      const Rational t = domain.lower + v * (domain.upper - domain.lower);
      CHECK(same_point(piece.map.at(t), de_casteljau(points, v)));
    }
  }
}

TEST_CASE("bezier_curve: points of weight zero vanish, but not all of them") {
  CHECK(bezier_curve({{0, 0, 0}, {1, 1, 1}, {0, 0, 0}}).map.degree() == 0);
  // A direction as control point: a branch of the hyperbola x y = 1 through infinity.
  const CurvePiece hyperbola = bezier_curve({{1, 0, 0}, {0, 0, ratio(1, 2)}, {0, 1, 0}});
  CHECK(hyperbola.map.coordinates() == rational_curve(polynomials({"t"}, {"(1-t)^2", "t^2", "t*(1-t)"})).coordinates());
  CHECK_THROWS_AS(bezier_curve({{0, 0, 0}, {0, 0, 0}}), InvalidInput);
  CHECK_THROWS_AS(bezier_curve({}), InvalidInput);
  CHECK_THROWS_AS(bezier_curve({{1, 0, 1}, {1, 1, 0, 1}}), InvalidInput);
}

TEST_CASE("bezier_patch: a bilinear saddle, rows belong to the first parameter") {
  const SurfacePiece saddle = bezier_patch({{{0, 0, 0, 1}, {0, 2, 0, 1}}, {{1, 0, 0, 1}, {1, 2, 3, 1}}});
  CHECK(saddle.map.coordinates() == polynomials({"s", "t"}, {"s", "2*t", "3*s*t", "1"}));
  CHECK(saddle.map.bidegree() == std::array<long, 2>{1, 1});
  CHECK(saddle.region->sides == std::array{Interval{0, 1}, Interval{0, 1}});
  CHECK_FALSE(saddle.region->triangle);
  // The same points on [1, 3] x [0, 2].
  const SurfacePiece moved =
      bezier_patch({{{0, 0, 0, 1}, {0, 2, 0, 1}}, {{1, 0, 0, 1}, {1, 2, 3, 1}}}, {Interval{1, 3}, Interval{0, 2}});
  CHECK(same_point(moved.map.at({2, ratio(1, 2)}), saddle.map.at({ratio(1, 2), ratio(1, 4)})));
  CHECK(same_point(moved.map.at({7, -3}), saddle.map.at({3, ratio(-3, 2)})));
}

TEST_CASE("bezier_patch: the same points as de Casteljau's algorithm in both directions") {
  Random random(6);
  std::vector<std::vector<ControlPoint>> rows(4, std::vector<ControlPoint>(3));
  for (auto& row : rows)
    for (ControlPoint& point : row)
      for (int c = 0; c < 4; ++c) point.push_back(ratio(random.between(-9, 9), random.between(1, 3)));
  const SurfacePiece piece = bezier_patch(rows);
  CHECK(piece.map.bidegree() == std::array<long, 2>{3, 2});
  for (long a = -1; a <= 3; ++a)
    for (long b = -1; b <= 3; ++b) {
      std::vector<ControlPoint> column;
      for (const auto& row : rows) column.push_back(de_casteljau(row, ratio(b, 2)));
      CHECK(same_point(piece.map.at({ratio(a, 2), ratio(b, 2)}), de_casteljau(column, ratio(a, 2))));
    }
}

TEST_CASE("bezier_patch: a raised degree is reduced, uneven rows are refused") {
  std::vector<std::vector<ControlPoint>> plane(3);
  for (long i = 0; i <= 2; ++i)
    for (long j = 0; j <= 3; ++j) plane[static_cast<std::size_t>(i)].push_back({ratio(i, 2), ratio(j, 3), 0, 1});
  const SurfacePiece piece = bezier_patch(plane);
  CHECK(piece.map.coordinates() == polynomials({"s", "t"}, {"s", "t", "0", "1"}));
  plane.back().pop_back();
  CHECK_THROWS_AS(bezier_patch(plane), InvalidInput);
  CHECK_THROWS_AS(bezier_patch({}), InvalidInput);
  CHECK_THROWS_AS(bezier_patch({{{1, 0, 1}, {0, 1, 1}}}), InvalidInput);
}

TEST_CASE("bezier_triangle: the order of its points and its multinomial coefficients") {
  const std::vector<std::string> names{"s", "t", "u"};
  // x, y and z pick out (2,0,0), (1,1,0) and (0,1,1); all weights are 1.
  const SurfacePiece patch =
      bezier_triangle(2, {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 1, 1}, {0, 0, 0, 1}});
  CHECK(patch.map.coordinates() == polynomials(names, {"s^2", "2*s*t", "2*t*u", "(s+t+u)^2"}));
  CHECK(patch.map.degree() == 2);
  CHECK(patch.region->triangle);
  CHECK(patch.region->sides == std::array{Interval{0, 1}, Interval{0, 1}});
  CHECK(triangle_point_count(3) == 10);
  CHECK_THROWS_AS(bezier_triangle(2, {{1, 0, 0, 1}}), InvalidInput);
}

TEST_CASE("bezier_triangle: a plane triangle in degree 3 has degree 1") {
  std::vector<ControlPoint> points;
  for (long not_s = 0; not_s <= 3; ++not_s)
    for (long k = 0; k <= not_s; ++k) points.push_back({ratio(3 - not_s, 3), ratio(not_s - k, 3), ratio(5 * k, 3), 1});
  const SurfacePiece patch = bezier_triangle(3, points);
  CHECK(patch.map.degree() == 1);
  CHECK(patch.map.coordinates() == polynomials({"s", "t", "u"}, {"s", "t", "5*u", "s+t+u"}));
}
