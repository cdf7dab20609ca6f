// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/curves.hpp>

#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>
#include <eliminant/symbolic/geometry/bounding_box.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using test::Random;

namespace {

const Rational half(Integer(1), Integer(2));

CurvePiece curve_of(const std::vector<std::string>& texts, const std::optional<Interval>& domain) {
  const std::vector<std::string> names{"t"};
  std::vector<Polynomial> coordinates;
  for (const std::string& text : texts) coordinates.push_back(parse_polynomial(text, names));
  return {rational_curve(coordinates), domain};
}

bool contains(const BoundingBox& box, const std::vector<Rational>& point) {
  for (std::size_t k = 0; k < box.size(); ++k) {
    const Rational value = point[k] / point.back();
    if (value < box[k].lower || box[k].upper < value) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("bounding_box: the control points of a curve on its domain") {
  // A parabola from (0, 0) over (1, 0) to (2, 4); a quarter of a circle with the points (1, 0), (1, 1), (0, 1).
  CHECK(*bounding_box(curve_of({"t", "t^2", "1"}, Interval{0, 2})) == BoundingBox{{0, 2}, {0, 4}});
  CHECK(*bounding_box(curve_of({"t", "t^2", "1"}, Interval{-1, 1})) == BoundingBox{{-1, 1}, {-1, 1}});
  CHECK(*bounding_box(curve_of({"1-t^2", "2*t", "1+t^2"}, Interval{0, 1})) == BoundingBox{{0, 1}, {0, 1}});
  CHECK(*bounding_box(curve_of({"t", "2*t", "3*t", "-1"}, Interval{1, 1})) ==
        BoundingBox{{-1, -1}, {-2, -2}, {-3, -3}});
}

TEST_CASE("bounding_box: none without a domain, nor where a weight is zero or changes its sign") {
  CHECK_FALSE(bounding_box(curve_of({"t", "t^2", "1"}, std::nullopt)).has_value());
  CHECK_FALSE(bounding_box(curve_of({"1", "t^2", "t"}, Interval{-1, 1})).has_value());
  CHECK_FALSE(bounding_box(curve_of({"1", "t^2", "t"}, Interval{0, 1})).has_value());
  CHECK(bounding_box(curve_of({"1", "t^2", "t"}, Interval{half, 1})).has_value());
  // Positive everywhere, but not its coefficients.
  CHECK_FALSE(bounding_box(curve_of({"1", "t^2", "10*t^2-10*t+3"}, Interval{0, 1})).has_value());
}

TEST_CASE("bounding_box: patches, rectangular and triangular") {
  const SurfacePiece patch = bezier_patch({{{0, 0, 0, 1}, {0, 1, 0, 1}}, {{1, 0, 0, 1}, {2, 2, 6, 2}}});
  CHECK(*bounding_box(patch) == BoundingBox{{0, 1}, {0, 1}, {0, 3}});
  const SurfacePiece triangle =
      bezier_triangle(2, {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {2, 0, 7, 1}, {2, 2, -6, 2}, {0, 2, 0, 1}});
  CHECK(*bounding_box(triangle) == BoundingBox{{0, 2}, {0, 2}, {-3, 7}});
  CHECK_FALSE(bounding_box(SurfacePiece{patch.map, std::nullopt}).has_value());
  const SurfacePiece mixed = bezier_patch({{{0, 0, 0, 1}, {0, 1, 0, 1}}, {{1, 0, 0, 1}, {2, 2, 6, -2}}});
  CHECK_FALSE(bounding_box(mixed).has_value());
}

TEST_CASE("bounding_box: random control points are within, and points of the curve and the patch, too") {
  Random random(99);
  const auto draw = [&] {
    const Rational w = static_cast<int>(random.between(1, 4));
    ControlPoint point;
    for (int k = 0; k < 3; ++k) point.push_back(Rational(static_cast<int>(random.between(-9, 9))) * w);
    point.push_back(w);
    return point;
  };
  for (int run = 0; run < 40; ++run) {
    std::vector<ControlPoint> points(static_cast<std::size_t>(random.between(2, 6)));
    for (ControlPoint& point : points) point = draw();
    const CurvePiece curve = bezier_curve(points, Interval{-1, 3});
    if (curve.map.degree() + 1 != static_cast<long>(points.size())) continue;
    const auto box = bounding_box(curve);
    REQUIRE(box.has_value());
    for (const ControlPoint& point : points) CHECK(contains(*box, point));
    for (int k = 0; k <= 8; ++k) CHECK(contains(*box, curve.map.at(Rational(k - 2) * half)));
    std::vector<std::vector<ControlPoint>> rows(3, std::vector<ControlPoint>(4));
    for (auto& row : rows)
      for (ControlPoint& point : row) point = draw();
    const SurfacePiece patch = bezier_patch(rows);
    const auto of_patch = bounding_box(patch);
    REQUIRE(of_patch.has_value());
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; j <= 2; ++j) CHECK(contains(*of_patch, patch.map.at({Rational(i) * half, Rational(j) * half})));
  }
}

TEST_CASE("are_disjoint: boxes that touch are not") {
  CHECK_FALSE(are_disjoint({{0, 1}, {0, 1}}, {{1, 2}, {1, 2}}));
  CHECK(are_disjoint({{0, 1}, {0, 1}}, {{half, 2}, {Rational(3) * half, 2}}));
}
