// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <intersect/curve_helpers.hpp>
#include <support/bezier_nets.hpp>

#include <eliminant/intersect/curve_surface/bezier_intersection.hpp>
#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/intersect/curves/curve_curve.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using bridge::ExactNet;
using bridge::HomogeneousPoint;

namespace {

/// The points in doubles, after all have been multiplied by `factor`, which must make them representable.
std::vector<HomogeneousPoint> exact_doubles(const ExactNet& net, long factor) {
  std::vector<HomogeneousPoint> points;
  for (const bridge::ExactPoint& p : net.points) {
    HomogeneousPoint& point = points.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const Rational value = Rational(factor) * p[k];
      REQUIRE(value.denominator().to_string().size() < 7);
      point[k] = std::stod(value.numerator().to_string()) / std::stod(value.denominator().to_string());
    }
  }
  return points;
}

/// Binomials up to degree 6 and thirds, sevenths of the planted curves.
constexpr long clearing = 60;

BezierCurve curve_of(const ExactNet& net) { return {exact_doubles(net, clearing)}; }
BezierPatch patch_of(const ExactNet& net) { return {{net.degrees[0], net.degrees[1]}, exact_doubles(net, clearing)}; }

bool has(const BezierIntersections& result, const std::vector<double>& parameters, unsigned long multiplicity) {
  return std::count_if(result.points.begin(), result.points.end(), [&](const BezierPoint& point) {
           for (std::size_t k = 0; k < parameters.size(); ++k)
             if (!(std::fabs(point.parameters[k] - parameters[k]) <= point.radius + 1e-15)) return false;
           return point.multiplicity == multiplicity && point.certified && point.radius < 1e-9;
         }) == 1;
}

const BezierPatch bilinear{{1, 1}, {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 1, 1}}};

BezierCurve upright(double x, double y) { return {{{x, y, -1, 1}, {x, y, 3, 1}}}; }

/// The sheets (3 s^2, 3 s^3 - 3 s, t) of s in [low, 3/2]; s = 1 and s = -1 have one image.
BezierPatch crossing_sheets(double low) {
  BezierPatch patch{{3, 1}, {}};
  for (int i = 0; i <= 3; ++i) {
    std::array<double, 3> s{};
    for (int k = 0; k < 3; ++k) s[static_cast<std::size_t>(k)] = k < i ? 1.5 : low;
    for (const double z : {0.0, 1.0})
      patch.points.push_back(
          {s[0] * s[1] + s[0] * s[2] + s[1] * s[2], 3 * s[0] * s[1] * s[2] - s[0] - s[1] - s[2], z, 1});
  }
  return patch;
}

}  // namespace

TEST_CASE("Bezier intersection: contacts of order 1 to 5 are proven in hardware doubles") {
  const Powers p = powers({1, -2, 1});
  const std::vector<std::pair<long, long>> fractions{{1, 2}, {1, 3}, {3, 4}};
  for (const std::pair<long, long>& fraction : fractions)
    for (unsigned order = 1; order <= 5; ++order) {
      const long numerator = fraction.first;
      const long denominator = fraction.second;
      CAPTURE(denominator);
      CAPTURE(order);
      const double at = static_cast<double>(numerator) / static_cast<double>(denominator);
      const Powers difference = root(numerator, denominator, order);
      const BezierIntersector plane(curve_of(curve_net({t, p, zero, one})));
      const BezierIntersections in_plane = plane.intersect(curve_of(curve_net({t, p + difference, zero, one})));
      CHECK(in_plane.status == Status::certified);
      CHECK(in_plane.by_boxes);
      CHECK(in_plane.points.size() == 1);
      CHECK(has(in_plane, {at, at}, order));

      const BezierIntersector patch(patch_of(saddle_net(3, -1)));
      const BezierIntersections on_patch =
          patch.intersect(curve_of(curve_net({t, t, on_saddle(3, -1, t, t) + difference, one})));
      CHECK(on_patch.status == Status::certified);
      if (order < 5) CHECK(on_patch.by_boxes);
      CHECK(on_patch.points.size() == 1);
      CHECK(has(on_patch, {at, at, at}, order));
    }
}

TEST_CASE("Bezier intersection: scaling, moving, reversing and elevating keep parameters and multiplicities") {
  const ExactNet curve = curve_net({t, t, on_saddle(1, 0, t, t) + root(1, 2, 2) * root(1, 4), one});
  const std::vector<HomogeneousPoint> patch = exact_doubles(saddle_net(1, 0), clearing);
  for (const int exponent : {-60, -7, 0, 30, 60})
    for (const double shift : {0.0, 0x1p20, -0x1p30}) {
      CAPTURE(exponent);
      CAPTURE(shift);
      const auto image = [&](std::vector<HomogeneousPoint> points) {
        for (HomogeneousPoint& point : points) {
          point[0] += shift * point[3];
          point[2] -= shift * point[3];
          for (std::size_t k = 0; k < 3; ++k) point[k] = std::ldexp(point[k], exponent);
        }
        return points;
      };
      const BezierIntersector intersector(BezierPatch{{2, 2}, image(patch)});
      const BezierCurve moved{image(exact_doubles(curve, clearing))};
      const BezierIntersections result = intersector.intersect(moved);
      CHECK(result.status == Status::certified);
      CHECK(result.by_boxes);
      CHECK(result.points.size() == 2);
      CHECK(has(result, {0.5, 0.5, 0.5}, 2));
      CHECK(has(result, {0.25, 0.25, 0.25}, 1));
      CHECK(std::is_sorted(result.points.begin(), result.points.end(),
                           [](const BezierPoint& a, const BezierPoint& b) { return a.parameters < b.parameters; }));
      const BezierIntersections back = intersector.intersect({{moved.points.rbegin(), moved.points.rend()}});
      CHECK(back.points.size() == 2);
      CHECK(has(back, {0.5, 0.5, 0.5}, 2));
      CHECK(has(back, {0.75, 0.25, 0.25}, 1));
      BezierCurve elevated;
      const std::size_t degree = moved.points.size() - 1;
      for (std::size_t i = 0; i <= degree + 1; ++i) {
        HomogeneousPoint& point = elevated.points.emplace_back();
        for (std::size_t k = 0; k < 4; ++k)
          point[k] = (i > 0 ? static_cast<double>(i) * moved.points[i - 1][k] : 0) +
                     (i <= degree ? static_cast<double>(degree + 1 - i) * moved.points[i][k] : 0);
      }
      const BezierIntersections same = intersector.intersect(elevated);
      CHECK(same.points.size() == 2);
      CHECK(has(same, {0.5, 0.5, 0.5}, 2));
      CHECK(has(same, {0.25, 0.25, 0.25}, 1));
    }
}

TEST_CASE("Bezier intersection: points on borders and in corners have their exact parameters") {
  const BezierIntersector intersector(bilinear);
  const BezierIntersections border = intersector.intersect(upright(0, 0.5));
  REQUIRE(border.points.size() == 1);
  CHECK(border.by_boxes);
  CHECK(border.points[0].parameters == std::array<double, 3>{0.25, 0, 0.5});
  CHECK(border.points[0].radius == 0);
  const BezierIntersections corner = intersector.intersect(upright(1, 1));
  REQUIRE(corner.points.size() == 1);
  CHECK(corner.points[0].parameters == std::array<double, 3>{0.5, 1, 1});
  CHECK(intersector.intersect(upright(0, -0x1p-40)).points.empty());
  // Curves that share both ends, touching in one of them.
  const BezierIntersector arc(BezierCurve{{{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 2, 0, 1}}});
  const BezierIntersections ends = arc.intersect({{{0, 0, 0, 1}, {2, 0, 0, 1}, {2, 2, 0, 1}}});
  CHECK(ends.status == Status::certified);
  CHECK(has(ends, {0, 0}, 2));
  CHECK(has(ends, {1, 1}, 1));
  for (const BezierPoint& point : ends.points)
    for (const double parameter : point.parameters) CHECK((parameter >= 0 && parameter <= 1));
}

TEST_CASE("Bezier intersection: weights on one side alone are no hindrance") {
  const BezierPatch weighted{{1, 1}, {{0, 0, 0, 1}, {0, 1, 0, 1}, {2, 0, 0, 2}, {1, 1, 1, 1}}};
  const BezierIntersections first = BezierIntersector(weighted).intersect(upright(0.5, 0.5));
  CHECK(first.status == Status::certified);
  CHECK(first.by_boxes);
  CHECK(first.points.size() == 1);
  const BezierIntersections second = BezierIntersector(bilinear).intersect({{{0.5, 0.5, -1, 1}, {1, 1, 6, 2}}});
  CHECK(second.by_boxes);
  CHECK(second.points.size() == 1);
}

TEST_CASE("Bezier intersection: a point where a border collapses is listed, without parameters on the patch") {
  const BezierPatch triangle{{1, 1}, {{0, 0, 1, 1}, {0, 0, 1, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}};
  const BezierIntersections result = BezierIntersector(triangle).intersect({{{0, 0, 2, 1}, {0, 0, 0, 1}}});
  CHECK(result.status == Status::certified);
  REQUIRE(result.points.size() == 1);
  CHECK(result.points[0].parameters[0] == doctest::Approx(0.5));
  CHECK(std::isnan(result.points[0].parameters[1]));
  CHECK(std::isnan(result.points[0].parameters[2]));
  CHECK(result.points[0].point[2] == doctest::Approx(1));
}

TEST_CASE("Bezier intersection: a curve in the plane of a patch that touches it in one point meets it there") {
  const BezierIntersector square(BezierPatch{{1, 1}, {{-1, -1, 0, 1}, {-1, 1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 1}}});
  // Through a corner, from a border outwards, tangent to a border.
  const std::vector<BezierCurve> curves{
      {{{0, 2, 0, 1}, {2, 0, 0, 1}}}, {{{1, 0, 0, 1}, {2, 0, 0, 1}}}, {{{-1, 2, 0, 1}, {0, 0, 0, 1}, {1, 2, 0, 1}}}};
  const std::vector<std::array<double, 3>> expected{{0.5, 1, 1}, {0, 1, 0.5}, {0.5, 0.5, 1}};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    CAPTURE(i);
    const BezierIntersections result = square.intersect(curves[i]);
    CHECK(result.status == Status::certified);
    CHECK(result.overlap.empty());
    CHECK(result.points.size() == 1);
    CHECK(has(result, {expected[i].begin(), expected[i].end()}, 1));
  }
  // Beside it, and along a border.
  CHECK(square.intersect({{{0, 2.5, 0, 1}, {2.5, 0, 0, 1}}}).points.empty());
  const BezierIntersections both = square.intersect({{{-3, -1, 0, 1}, {0, -1, 0, 1}}});
  CHECK(both.status == Status::infinite);
  CHECK(both.points.empty());
  REQUIRE(both.overlap.size() == 1);
  CHECK(both.overlap[0][0] == doctest::Approx(2.0 / 3));
}

TEST_CASE("Bezier intersection: each sheet of the patch is a point of its own") {
  const BezierCurve line{{{2, 0, 0.25, 1}, {4, 0, 0.75, 1}}};
  const BezierIntersections one_sheet = BezierIntersector(crossing_sheets(0.5)).intersect(line);
  CHECK(one_sheet.by_boxes);
  CHECK(one_sheet.points.size() == 1);
  CHECK(has(one_sheet, {0.5, 0.5, 0.5}, 1));
  const BezierIntersections two_sheets = BezierIntersector(crossing_sheets(-1.5)).intersect(line);
  CHECK(two_sheets.by_boxes);
  CHECK(two_sheets.points.size() == 2);
  CHECK(has(two_sheets, {0.5, 5.0 / 6, 0.5}, 1));
  CHECK(has(two_sheets, {0.5, 1.0 / 6, 0.5}, 1));
}

TEST_CASE("Bezier intersection: singular points of either curve, and common parts, are left to the matrix engines") {
  // Two cusps in one point, at parameters and coordinates that doubles round.
  const BezierIntersector cusp(BezierCurve{{{12, 6, 0, 3}, {7, 3, 0, 3}, {6, 3, 0, 3}, {6, 3, 0, 3}}});
  const BezierIntersections cusps = cusp.intersect({{{15, 9, 0, 3}, {7, 3, 0, 3}, {6, 3, 0, 3}, {6, 3, 0, 3}}});
  CHECK(cusps.status == Status::certified);
  CHECK_FALSE(cusps.by_boxes);
  CHECK(cusps.points.size() == 1);
  CHECK(has(cusps, {1, 1}, 6));
  // Far from the origin the parameters are no less accurate.
  constexpr double far = 0x1p40;
  const BezierIntersector far_cusp(
      BezierCurve{{{12 + far, 6, 0, 3}, {7 + far, 3, 0, 3}, {6 + far, 3, 0, 3}, {6 + far, 3, 0, 3}}});
  CHECK(has(far_cusp.intersect({{{15 + far, 9, 0, 3}, {7 + far, 3, 0, 3}, {6 + far, 3, 0, 3}, {6 + far, 3, 0, 3}}}),
            {1, 1}, 6));
  const BezierIntersector segment(BezierCurve{{{0, 0, 0, 1}, {4, 4, 0, 1}}});
  const BezierIntersections overlap = segment.intersect({{{2, 2, 0, 1}, {6, 6, 0, 1}}});
  CHECK(overlap.status == Status::infinite);
  REQUIRE(overlap.overlap.size() == 1);
  CHECK(overlap.overlap[0][0] == doctest::Approx(0));
  CHECK(overlap.overlap[0][1] == doctest::Approx(0.5));
  CHECK(segment.intersect({{{5, 5, 0, 1}, {6, 6, 0, 1}}}).points.empty());
}

TEST_CASE("Bezier intersection: the engine box hands on what it cannot decide") {
  Options options;
  options.engine = Engine::box;
  options.field = Field::real;
  const Context context;
  // Irrational contacts: y = (2 x^2 - 1)^2 against y = 0.
  const symbolic::Interval unit{0, 1};
  const CurveResult result = intersect_curve_curve(
      {map_of({"t", "4*t^4 - 4*t^2 + 1", "1"}, unit), map_of({"t", "0", "1"}, unit)}, options, context);
  CHECK(result.status == Status::certified);
  REQUIRE(result.solutions.size() == 1);
  CHECK(result.solutions[0].multiplicity == 2);
}

TEST_CASE("Bezier intersection: boxes and the exact engine agree on small pairs full of coincidences") {
  Draw draw(31);
  unsigned compared = 0;
  for (int round = 0; round < 150; ++round) {
    CAPTURE(round);
    const bool weighted = round % 3 == 0;
    const auto points = [&](long degree) {
      std::vector<symbolic::ControlPoint> result;
      for (long i = 0; i <= degree; ++i) {
        const Rational w = weighted ? power_of_two(draw.between(-2, 2)) : Rational(1);
        result.push_back({w * Rational(draw.between(-3, 3)), w * Rational(draw.between(-3, 3)), w});
      }
      return result;
    };
    std::vector<symbolic::ControlPoint> a = points(draw.between(1, 3));
    const std::vector<symbolic::ControlPoint> b = points(draw.between(1, 3));
    if (round % 4 == 1) a.front() = b.front();
    if (round % 5 == 2) a.back() = b.back();
    const symbolic::ParametricCurve first{{symbolic::bezier_curve(a)}};
    const symbolic::ParametricCurve second{{symbolic::bezier_curve(b)}};
    if (first.pieces[0].map.degree() < 1 || second.pieces[0].map.degree() < 1) continue;
    Options options;
    options.field = Field::real;
    const Context context;
    options.engine = Engine::box;
    const CurveResult boxes = intersect_curve_curve({first, second}, options, context);
    if (boxes.engine.method != "box") continue;
    options.engine = Engine::exact;
    const CurveResult exact = intersect_curve_curve({first, second}, options, context);
    if (exact.status != Status::certified) continue;
    ++compared;
    REQUIRE(boxes.solutions.size() == exact.solutions.size());
    for (const CurveSolution& solution : boxes.solutions)
      CHECK(std::count_if(exact.solutions.begin(), exact.solutions.end(), [&](const CurveSolution& other) {
              return may_agree(solution.t, other.t) && may_agree(solution.u, other.u) &&
                     solution.multiplicity == other.multiplicity;
            }) == 1);
  }
  CHECK(compared > 80);
}

TEST_CASE("Bezier intersection: bad input is refused") {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<HomogeneousPoint> four = bilinear.points;
  const BezierCurve segment{{{0, 0, 0, 1}, {1, 1, 0, 1}}};
  const auto patch = [](std::array<std::size_t, 2> degree, std::vector<HomogeneousPoint> points) {
    return BezierIntersector(BezierPatch{degree, std::move(points)});
  };
  const auto curve = [](std::vector<HomogeneousPoint> points) {
    return BezierIntersector(BezierCurve{std::move(points)});
  };
  CHECK_THROWS_AS(patch({0, 1}, {four[0], four[1]}), InvalidInput);
  CHECK_THROWS_AS(patch({1, 0}, {four[0], four[1]}), InvalidInput);
  CHECK_THROWS_AS(patch({1, 1}, {four[0], four[1], four[2]}), InvalidInput);
  CHECK_THROWS_AS(patch({1, 1}, {four[0], four[1], four[2], {0, infinity, 0, 1}}), InvalidInput);
  CHECK_THROWS_AS(patch({1, 1}, {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}), InvalidInput);
  CHECK_THROWS_AS(curve({}), InvalidInput);
  CHECK_THROWS_AS(curve({{0, 0, 0, 1}}), InvalidInput);
  CHECK_THROWS_AS(curve({{0, 0, 0, 1}, {1, 0, 1, 1}}), InvalidInput);
  CHECK_THROWS_AS(curve({{0, 0, 0, 1}, {NAN, 0, 0, 1}}), InvalidInput);
  CHECK_THROWS_AS(curve({{1, 0, 0, 0}, {0, 1, 0, 0}}), InvalidInput);
  CHECK_THROWS_AS(curve({{1, 2, 0, 1}, {3, 6, 0, 3}, {2, 4, 0, 2}}), InvalidInput);

  const BezierIntersector on_patch(bilinear);
  CHECK_THROWS_AS(on_patch.intersect({{}}), InvalidInput);
  CHECK_THROWS_AS(on_patch.intersect({{{0, 0, 0, 1}}}), InvalidInput);
  CHECK_THROWS_AS(on_patch.intersect({{{0, 0, 0, 1}, {0, 0, NAN, 1}}}), InvalidInput);
  CHECK_THROWS_AS(on_patch.intersect({{{1, 0, 0, 0}, {0, 1, 0, 0}}}), InvalidInput);
  // One point, beside the patch and on it, also with other weights.
  CHECK_THROWS_AS(on_patch.intersect({{{5, 5, 5, 1}, {5, 5, 5, 1}}}), InvalidInput);
  CHECK_THROWS_AS(on_patch.intersect({{{0, 0, 0, 1}, {0, 0, 0, 2}}}), InvalidInput);
  CHECK_THROWS_AS(on_patch.intersect({{{0.1, 0.2, 0.3, 0.7}, {0.2, 0.4, 0.6, 1.4}}}), InvalidInput);
  CHECK_THROWS_AS(BezierIntersector(segment).intersect({{{0, 0, 1, 1}, {1, 0, 0, 1}}}), InvalidInput);
  // Nearly one point is none.
  CHECK_NOTHROW(on_patch.intersect({{{5, 5, 5, 1}, {5, 5, std::nextafter(5, 6), 1}}}));
  Context context;
  context.limit_seconds(-1);
  CHECK_THROWS_AS(on_patch.intersect({{{0, 0, 0, 1}, {0.5, 0, 0, 1}, {1, 0, 0, 1}}}, context), LimitReached);
}
