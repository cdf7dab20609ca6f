// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/geometry/nurbs.hpp>
#include <support/curves.hpp>
#include <support/homogeneous_points.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;

namespace {

Rational ratio(long a, long b) { return {Integer(a), Integer(b)}; }

// The recursion of Cox and de Boor for the basis functions, with 0/0 = 0; `span` holds the index of the span of t.
Rational basis(const KnotVector& vector, std::size_t i, std::size_t p, std::size_t span, const Rational& t) {
  if (p == 0) return i == span ? 1 : 0;
  const std::vector<Rational>& u = vector.knots;
  Rational sum;
  if (u[i] < u[i + p]) sum = sum + (t - u[i]) / (u[i + p] - u[i]) * basis(vector, i, p - 1, span, t);
  if (u[i + 1] < u[i + p + 1])
    sum = sum + (u[i + p + 1] - t) / (u[i + p + 1] - u[i + 1]) * basis(vector, i + 1, p - 1, span, t);
  return sum;
}

std::size_t span_of(const KnotVector& vector, const Interval& interval) {
  std::size_t span = 0;
  while (!(vector.knots[span] == interval.lower && vector.knots[span + 1] == interval.upper)) ++span;
  return span;
}

ControlPoint point_by_basis(const KnotVector& vector, const std::vector<ControlPoint>& points, std::size_t span,
                            const Rational& t) {
  ControlPoint sum(points.front().size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Rational weight = basis(vector, i, vector.degree, span, t);
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] = sum[c] + weight * points[i][c];
  }
  return sum;
}

// Sorted knots without one more than degree + 1 times; sometimes clamped, often with multiple knots.
KnotVector random_knots(Random& random, std::size_t degree, std::size_t points) {
  while (true) {
    KnotVector vector{degree, {}};
    const long range = random.between(2, 12);
    for (std::size_t i = 0; i < points + degree + 1; ++i)
      vector.knots.push_back(ratio(random.between(-range, range), random.next() % 3 == 0 ? 3 : 1));
    std::sort(vector.knots.begin(), vector.knots.end());
    if (random.next() % 3 == 0)
      for (std::size_t i = 1; i <= degree; ++i) {
        vector.knots[i] = vector.knots[0];
        vector.knots[points + i - 1] = vector.knots.back();
      }
    try {
      require_knots(vector, points);
      return vector;
    } catch (const InvalidInput&) {
    }
  }
}

std::vector<ControlPoint> random_points(Random& random, std::size_t count) {
  std::vector<ControlPoint> points(count);
  for (ControlPoint& point : points)
    for (int c = 0; c < 4; ++c) point.push_back(ratio(random.nonzero(9), random.between(1, 4)));
  return points;
}

}  // namespace

TEST_CASE("nurbs_curve: the pieces equal the basis functions of Cox and de Boor, for any knots") {
  Random random(21);
  for (int round = 0; round < 60; ++round) {
    const std::size_t degree = 1 + random.next() % 4;
    const std::size_t count = degree + 1 + random.next() % 5;
    const KnotVector knots = random_knots(random, degree, count);
    const std::vector<ControlPoint> points = random_points(random, count);
    const ParametricCurve curve = nurbs_curve(knots, points);
    REQUIRE(!curve.pieces.empty());
    CHECK(curve.pieces.front().domain->lower == knots.knots[degree]);
    CHECK(curve.pieces.back().domain->upper == knots.knots[count]);
    for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
      const auto& [map, domain] = curve.pieces[i];
      if (i > 0) CHECK(domain->lower == curve.pieces[i - 1].domain->upper);
      const std::size_t span = span_of(knots, *domain);
      for (long k = 0; k <= 5; ++k) {
        const Rational t = domain->lower + ratio(k, 5) * (domain->upper - domain->lower);
        CHECK(same_point(map.at(t), point_by_basis(knots, points, span, t)));
      }
    }
  }
}

TEST_CASE("nurbs_curve: the full circle from nine points, four pieces of degree 2") {
  // Quarters of weights 1, 1, 2; each begins with the weight the one before ends with.
  const KnotVector knots{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}};
  const std::vector<ControlPoint> points{{1, 0, 1},   {1, 1, 1},  {0, 2, 2},  {-2, 2, 2}, {-4, 0, 4},
                                         {-4, -4, 4}, {0, -8, 8}, {8, -8, 8}, {16, 0, 16}};
  const ParametricCurve circle = nurbs_curve(knots, points);
  REQUIRE(circle.pieces.size() == 4);
  for (const CurvePiece& piece : circle.pieces) {
    CHECK(piece.map.degree() == 2);
    const auto& c = piece.map.coordinates();
    CHECK(c[0] * c[0] + c[1] * c[1] == c[2] * c[2]);
  }
  // The first piece is the quarter circle (1 - t^2 : 2t : 1 + t^2), the second one a quarter turn further.
  CHECK(same_point(circle.pieces[0].map.at(ratio(1, 2)), {3, 4, 5}));
  CHECK(same_point(circle.pieces[1].map.at(ratio(3, 2)), {-4, 3, 5}));
  CHECK(same_point(circle.pieces[3].map.at(4), {1, 0, 1}));
}

TEST_CASE("bezier_spans: a clamped vector without inner knots gives back its points") {
  Random random(3);
  const std::vector<ControlPoint> points = random_points(random, 4);
  const std::vector<BezierSpan> spans = bezier_spans({3, {2, 2, 2, 2, 7, 7, 7, 7}}, points);
  REQUIRE(spans.size() == 1);
  CHECK(spans[0].span == Interval{2, 7});
  CHECK(spans[0].points == points);
}

TEST_CASE("bezier_spans: a uniform quadratic spline meets the midpoints of its legs") {
  const std::vector<BezierSpan> spans = bezier_spans({2, {0, 1, 2, 3, 4, 5, 6}}, {{0}, {4}, {10}, {2}});
  REQUIRE(spans.size() == 2);
  CHECK(spans[0].points == std::vector<ControlPoint>{{2}, {4}, {7}});
  CHECK(spans[1].points == std::vector<ControlPoint>{{7}, {10}, {6}});
  CHECK(spans[1].span == Interval{3, 4});
}

TEST_CASE("nurbs_curve: inserting a knot changes no point") {
  // The knot 3/2 inserted into the cubic by Boehm's formula.
  const KnotVector knots{3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}};
  Random random(8);
  const std::vector<ControlPoint> points = random_points(random, 6);
  const Rational x = ratio(3, 2);
  std::vector<ControlPoint> finer;
  for (std::size_t i = 0; i <= points.size(); ++i) {
    // knots[4] <= x < knots[5]: points 2, 3, 4 are replaced.
    const Rational& low = knots.knots[i];
    const Rational share = i <= 1 ? Rational(1) : i >= 5 ? Rational(0) : (x - low) / (knots.knots[i + 3] - low);
    ControlPoint point(4);
    for (std::size_t c = 0; c < 4; ++c) {
      if (i < points.size()) point[c] = point[c] + share * points[i][c];
      if (i > 0) point[c] = point[c] + (Rational(1) - share) * points[i - 1][c];
    }
    finer.push_back(point);
  }
  const ParametricCurve coarse = nurbs_curve(knots, points);
  const ParametricCurve split = nurbs_curve({3, {0, 0, 0, 0, 1, x, 2, 3, 3, 3, 3}}, finer);
  REQUIRE(coarse.pieces.size() == 3);
  REQUIRE(split.pieces.size() == 4);
  CHECK(split.pieces[0].map.coordinates() == coarse.pieces[0].map.coordinates());
  CHECK(split.pieces[1].map.coordinates() == coarse.pieces[1].map.coordinates());
  CHECK(split.pieces[2].map.coordinates() == coarse.pieces[1].map.coordinates());
  CHECK(split.pieces[3].map.coordinates() == coarse.pieces[2].map.coordinates());
}

TEST_CASE("nurbs_surface: the pieces equal products of basis functions, in the order of their spans") {
  Random random(77);
  for (int round = 0; round < 8; ++round) {
    const std::array<std::size_t, 2> degrees{1 + random.next() % 3, 1 + random.next() % 2};
    const std::array<std::size_t, 2> counts{degrees[0] + 1 + random.next() % 3, degrees[1] + 1 + random.next() % 3};
    const std::array<KnotVector, 2> knots{random_knots(random, degrees[0], counts[0]),
                                          random_knots(random, degrees[1], counts[1])};
    std::vector<std::vector<ControlPoint>> rows;
    for (std::size_t i = 0; i < counts[0]; ++i) rows.push_back(random_points(random, counts[1]));
    const ParametricSurface surface = nurbs_surface(knots, rows);
    const SurfacePiece* before = nullptr;
    for (const SurfacePiece& piece : surface.pieces) {
      const auto& sides = piece.region->sides;
      if (before != nullptr && before->region->sides[0] == sides[0])
        CHECK(before->region->sides[1].upper == sides[1].lower);
      else if (before != nullptr)
        CHECK(before->region->sides[0].upper == sides[0].lower);
      before = &piece;
      for (long a = 0; a <= 3; ++a)
        for (long b = 0; b <= 3; ++b) {
          const Rational s = sides[0].lower + ratio(a, 3) * (sides[0].upper - sides[0].lower);
          const Rational t = sides[1].lower + ratio(b, 3) * (sides[1].upper - sides[1].lower);
          std::vector<ControlPoint> column;
          for (const auto& row : rows) column.push_back(point_by_basis(knots[1], row, span_of(knots[1], sides[1]), t));
          CHECK(same_point(piece.map.at({s, t}), point_by_basis(knots[0], column, span_of(knots[0], sides[0]), s)));
        }
    }
  }
}

TEST_CASE("require_knots: number, order, multiplicity and domain") {
  const auto accepted = [](std::size_t degree, std::vector<Rational> knots, std::size_t points) {
    try {
      require_knots({degree, std::move(knots)}, points);
      return true;
    } catch (const InvalidInput&) {
      return false;
    }
  };
  CHECK(accepted(2, {0, 0, 0, 1, 1, 1}, 3));
  CHECK(accepted(2, {0, 1, 2, 3, 4, 5}, 3));
  CHECK(accepted(2, {0, 0, 0, 1, 1, 1, 2, 2, 2}, 6));
  CHECK_FALSE(accepted(2, {0, 0, 1, 1}, 3));
  CHECK_FALSE(accepted(2, {0, 0, 0, 1, 1, 1, 1}, 3));
  CHECK_FALSE(accepted(2, {0, 0, 0, 2, 1, 3, 3}, 4));
  CHECK_FALSE(accepted(2, {0, 0, 0, 1, 1, 1, 1, 2, 2, 2}, 7));
  CHECK_FALSE(accepted(2, {0, 1, 2, 2, 3, 4}, 3));
  CHECK_FALSE(accepted(2, {0, 0, 1, 1, 1}, 2));
  CHECK_FALSE(accepted(0, {0, 1, 2}, 2));
}
