// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/patches/triangle_charts.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

using namespace eliminant;
using intersect::TriangleChart;
using symbolic::Rational;

namespace {

/// A rational triangle of degree 3 in general position.
symbolic::SurfacePiece general_triangle() {
  std::vector<symbolic::ControlPoint> points;
  for (long k = 0; k < 10; ++k) {
    const Rational weight = Rational(2 + k % 3);
    points.push_back({weight * Rational(k * k % 7), weight * Rational(3 * k % 5), weight * Rational(k % 4), weight});
  }
  return symbolic::bezier_triangle(3, points);
}

/// The barycentric coordinates of a point of a chart, from those in doubles.
std::array<double, 3> place(const TriangleChart& chart, double a, double b) {
  const auto [u, v] = chart.corner.at(a, b);
  return {u, v, 1 - u - v};
}

}  // namespace

TEST_CASE("Triangle charts: each is the triangle's map at the barycentric coordinates it says") {
  const symbolic::SurfacePiece triangle = general_triangle();
  for (std::size_t which = 0; which < 3; ++which)
    for (const TriangleChart& chart : intersect::triangle_charts(triangle, which)) {
      CHECK_FALSE(chart.piece.region->triangle);
      CHECK(chart.piece.map.bidegree() == std::array<long, 2>{3, 3});
      for (const symbolic::Polynomial& p : chart.piece.map.coordinates()) CHECK(p.total_degree() <= 3);
      for (long i = 0; i <= 4; ++i)
        for (long j = 0; j <= 4; ++j) {
          const auto own = chart.piece.map.at({Rational(i) / Rational(4), Rational(j) / Rational(4)});
          const auto at = place(chart, 0.25 * static_cast<double>(i), 0.25 * static_cast<double>(j));
          for (const double x : at) CHECK(x > -1e-15);
          std::vector<Rational> parameters(3);
          for (std::size_t k = 0; k < 3; ++k) parameters[k] = bridge::exactly(at[k]);
          const auto whole = triangle.map.at(parameters);
          for (std::size_t k = 0; k < 3; ++k)
            CHECK(bridge::nearest(own[k] / own[3]) ==
                  doctest::Approx(bridge::nearest(whole[k] / whole[3])).epsilon(1e-13));
        }
    }
}

TEST_CASE("Triangle charts: outer sides are borders of the triangle, inner ones are common to two charts") {
  const symbolic::SurfacePiece triangle = general_triangle();
  for (std::size_t which = 0; which < 3; ++which) {
    const auto charts = intersect::triangle_charts(triangle, which);
    REQUIRE(charts.size() == 3);
    double area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const intersect::TriangleCorner& corner = charts[i].corner;
      for (const double x : {0.0, 0.3, 1.0})
        for (const std::size_t axis : {0U, 1U}) {
          const auto at = axis == 0 ? place(charts[i], 0, x) : place(charts[i], x, 0);
          CHECK(std::fabs(at[corner.border(axis)]) < 1e-15);
          // The parameter that the border is followed by grows where the chart says so.
          const auto next = axis == 0 ? place(charts[i], 0, x + 0.1) : place(charts[i], x + 0.1, 0);
          const std::size_t followed = corner.border(axis) == 1 ? 0 : 1;
          CHECK((next[followed] > at[followed]) == corner.follows_border(axis));
        }
      // The line from the middle of a side to the inner point: u = 1 here, v = 1 in the next chart.
      const auto& next = charts[(i + 1) % 3];
      for (const double x : {0.0, 0.5, 1.0}) {
        const auto at = place(charts[i], 1, x);
        double nearest = 1;
        for (int k = 0; k <= 1000; ++k) {
          const auto other = place(next, k / 1000.0, 1);
          nearest = std::min(nearest, std::hypot(at[0] - other[0], at[1] - other[1]));
        }
        CHECK(nearest < 1e-3);
      }
      // Twice the area, counterclockwise.
      const std::array<std::array<double, 3>, 4> corners{place(charts[i], 0, 0), place(charts[i], 1, 0),
                                                         place(charts[i], 1, 1), place(charts[i], 0, 1)};
      for (std::size_t k = 0; k < 4; ++k) {
        const auto& p = corners[k];
        const auto& q = corners[(k + 1) % 4];
        area += p[0] * q[1] - p[1] * q[0];
      }
    }
    CHECK(area == doctest::Approx(1).epsilon(1e-14));
  }
}
