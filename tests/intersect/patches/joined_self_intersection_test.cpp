// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/surface_surface.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::ParametricSurface;
using symbolic::Rational;

namespace {

SurfaceResult with_itself(const ParametricSurface& surface) {
  Options options;
  options.tolerance = 1e-5;
  return intersect_surface_with_itself({surface}, options, Context());
}

/// One map on a grid.
ParametricSurface in_pieces(const PatchText& text, const std::vector<Rational>& u, const std::vector<Rational>& v) {
  ParametricSurface surface;
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
    for (std::size_t j = 0; j + 1 < v.size(); ++j)
      surface.pieces.push_back(patch(text, {symbolic::Interval{u[i], u[i + 1]}, symbolic::Interval{v[j], v[j + 1]}}));
  return surface;
}

/// A polygon in x and z, from y = 0 to y = 1: kinks at u = 1, 2, ...
ParametricSurface folded_strip(const std::vector<std::array<long, 2>>& polygon) {
  symbolic::KnotVector along{1, {0}};
  for (std::size_t i = 0; i < polygon.size(); ++i) along.knots.emplace_back(static_cast<long>(i));
  along.knots.push_back(along.knots.back());
  std::vector<std::vector<symbolic::ControlPoint>> rows;
  for (const auto& [x, z] : polygon) rows.push_back({{x, 0, z, 1}, {x, 1, z, 1}});
  return symbolic::nurbs_surface({along, symbolic::KnotVector{1, {0, 0, 1, 1}}}, rows);
}

/// The circle of the x, y plane as a NURBS curve of four pieces, the weights of the corners near sqrt(1/2), with the
/// points of the second parameter from `profile`: distance from the axis and height.
ParametricSurface turned(const std::vector<std::array<Rational, 2>>& profile, const symbolic::KnotVector& along) {
  const symbolic::KnotVector turn{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}};
  const std::vector<std::array<long, 2>> corners{{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                                 {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  std::vector<std::vector<symbolic::ControlPoint>> rows;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Rational w = i % 2 == 0 ? Rational(1) : ratio(7, 10);
    rows.emplace_back();
    for (const auto& [distance, height] : profile)
      rows.back().push_back(
          {w * distance * Rational(corners[i][0]), w * distance * Rational(corners[i][1]), w * height, w});
  }
  return symbolic::nurbs_surface({turn, along}, rows);
}

ParametricSurface triangle(const PatchText& text) {
  static const std::vector<std::string> names{"u", "v", "w"};
  std::vector<symbolic::Polynomial> forms;
  for (const std::string& coordinate : {text.x, text.y, text.z, text.w})
    forms.push_back(symbolic::parse_polynomial(coordinate, names));
  const symbolic::Interval unit{0, 1};
  return {{{symbolic::RationalSurface(symbolic::RationalSurface::Kind::triangular, std::move(forms)),
            symbolic::ParameterRegion{{unit, unit}, true}}}};
}

void check_preimages(const SurfaceResult& result, const std::function<SpacePoint(double, double)>& map) {
  for (const SurfaceComponent& component : result.components)
    for (const SurfacePoint& at : component.points) {
      const auto& [u, v, s, t] = at.parameters;
      CHECK(std::hypot(u - s, v - t) > 1e-3);
      double gap = 0;
      for (std::size_t k = 0; k < 3; ++k)
        gap = std::max({gap, std::fabs(map(u, v)[k] - at.point[k]), std::fabs(map(s, t)[k] - at.point[k])});
      CHECK(gap < 1e-11);
    }
}

const PatchText nodal{"u^2 - 1", "u^3 - u", "v"};
const PatchText enneper{"u - u^3/3 + u*v^2", "v - v^3/3 + v*u^2", "u^2 - v^2"};

SpacePoint on_enneper(double u, double v) {
  return {u - u * u * u / 3 + u * v * v, v - v * v * v / 3 + v * u * u, u * u - v * v};
}

}  // namespace

TEST_CASE("Self-intersection of several pieces: the same as of one patch, wherever it is cut") {
  const std::vector<std::vector<Rational>> cuts{{-2, 2}, {-2, 0, 2}, {-2, ratio(-1, 3), ratio(1, 2), 2}};
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (std::size_t j = 0; j < cuts.size(); ++j) {
      if (i == 0 && j == 0) continue;
      CAPTURE(i);
      CAPTURE(j);
      const SurfaceResult result = with_itself(in_pieces(enneper, cuts[i], cuts[j]));
      CHECK(summary(result) == "2 0 0 0 0 certified");
      check_preimages(result, on_enneper);
      for (const SurfaceComponent& curve : result.components) {
        CHECK(curve.start.kind == BranchEndKind::border);
        CHECK(curve.end.kind == BranchEndKind::border);
        // The curves lie in the planes x = 0 and y = 0.
        CHECK(farthest(curve, [](const SpacePoint& p) { return std::min(std::fabs(p[0]), std::fabs(p[1])); }) <=
              curve.error);
      }
    }
  const SurfaceResult line =
      with_itself(in_pieces(nodal, {ratio(-3, 2), ratio(-1, 3), ratio(1, 2), ratio(3, 2)}, {0, ratio(2, 5), 1}));
  CHECK(line.status == Status::certified);
  CHECK(line.counts.curves == 1);
  REQUIRE(!line.components.empty());
  CHECK(length_of(line.components[0]) == doctest::Approx(1));
}

TEST_CASE("Self-intersection of several pieces: seams, smooth or with a kink, are none") {
  CHECK(summary(with_itself(half_cylinder())) == "0 0 0 0 0 certified");
  CHECK(summary(with_itself(in_pieces({"u", "v", "u*v"}, {0, 1, 2, 3}, {0, 1, 2}))) == "0 0 0 0 0 certified");
  // Right angles, acute ones, sides of very different length.
  CHECK(summary(with_itself(folded_strip({{0, 0}, {1, 1}, {2, 0}, {3, 1}}))) == "0 0 0 0 0 certified");
  CHECK(summary(with_itself(folded_strip({{0, 0}, {5, 1}, {0, 2}, {5, 3}}))) == "0 0 0 0 0 certified");
  CHECK(summary(with_itself(folded_strip({{0, 0}, {1, 0}, {1, 50}, {2, 50}}))) == "0 0 0 0 0 certified");
}

TEST_CASE("Self-intersection of several pieces: a strip that crosses itself") {
  const SurfaceResult result = with_itself(folded_strip({{0, 0}, {3, 3}, {3, 0}, {0, 2}}));
  CHECK(summary(result) == "1 0 0 0 0 certified");
  REQUIRE(result.components.size() == 1);
  // x = z and z = 2 - 2 x / 3.
  CHECK(farthest(result.components[0], [](const SpacePoint& p) { return std::hypot(p[0] - 1.2, p[2] - 1.2); }) <=
        1e-12);
  for (const SurfacePoint& at : result.components[0].points) {
    CHECK(std::fabs(at.parameters[0] - 0.4) < 1e-12);
    CHECK(std::fabs(at.parameters[2] - 2.6) < 1e-12);
  }
}

TEST_CASE("Self-intersection of several pieces: where a surface closes there is none") {
  const symbolic::KnotVector straight{1, {0, 0, 1, 1}};
  CHECK(summary(with_itself(turned({{1, 0}, {1, 1}}, straight))) == "0 0 0 0 0 certified");
  // A ring that closes in both parameters: a square is turned.
  const symbolic::KnotVector square{1, {0, 0, 1, 2, 3, 4, 4}};
  CHECK(summary(with_itself(turned({{2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0}}, square))) == "0 0 0 0 0 certified");
  // A profile that crosses itself: one circle, cut where the surface closes.
  const symbolic::KnotVector crossing{1, {0, 0, 1, 2, 3, 3}};
  const SurfaceResult circle = with_itself(turned({{2, 0}, {3, 2}, {2, 2}, {3, 0}}, crossing));
  CHECK(summary(circle) == "1 0 0 0 0 certified");
  REQUIRE(circle.components.size() == 1);
  for (const SurfacePoint& at : circle.components[0].points) CHECK(std::fabs(at.point[2] - 1) < 1e-12);
  CHECK(circle.components[0].start.kind == BranchEndKind::border);
  CHECK(std::hypot(circle.components[0].points.front().point[0] - circle.components[0].points.back().point[0],
                   circle.components[0].points.front().point[1] - circle.components[0].points.back().point[1]) < 1e-12);
}

TEST_CASE("Self-intersection of several pieces: what is not proven is named, with its place") {
  // A fold back onto itself, and a pole.
  const SurfaceResult fold = with_itself(folded_strip({{0, 0}, {1, 0}, {0, 0}}));
  CHECK(fold.status != Status::certified);
  const SurfaceResult pole = with_itself(turned({{0, 0}, {1, 1}}, symbolic::KnotVector{1, {0, 0, 1, 1}}));
  CHECK(pole.status == Status::numeric);
  REQUIRE(!pole.singular_points.empty());
  for (const SurfaceSingularPoint& point : pole.singular_points) {
    CHECK(point.kind == SurfaceSingularity::undecided);
    CHECK(std::hypot(point.at.point[0], point.at.point[1], point.at.point[2]) < 0.1);
  }
  // A pinch point.
  const SurfaceResult pinch = with_itself(in_pieces({"u*v", "u", "v^2"}, {-1, ratio(1, 3), 1}, {-1, ratio(1, 2), 1}));
  CHECK(pinch.status == Status::numeric);
  REQUIRE(pinch.singular_points.size() == 1);
  for (const double parameter : pinch.singular_points[0].at.parameters)
    CHECK(std::fabs(parameter) <= pinch.singular_points[0].radius);
  // Pieces that do not meet.
  ParametricSurface torn = in_pieces({"u", "v", "0"}, {0, 1}, {0, 1});
  torn.pieces.push_back(patch({"u", "v", "1"}, {symbolic::Interval{1, 2}, symbolic::Interval{0, 1}}));
  const SurfaceResult apart = with_itself(torn);
  CHECK(apart.status == Status::numeric);
  CHECK(apart.warnings.at(0) == "pieces that are neighbours do not have the same points on the side between them");
}

TEST_CASE("Self-intersection of triangles, and of a patch whose weights have both signs") {
  const std::string sum = "(u + v + w)";
  CHECK(summary(with_itself(triangle({"u", "v", "0", sum}))) == "0 0 0 0 0 certified");
  // The nodal cubic of p = 4 u + v - 2, drawn along v: p = 1 and p = -1 meet.
  const std::string p = "(4*u - 2*" + sum + " + v)";
  const SurfaceResult line = with_itself(triangle(
      {"(" + p + "^2 - " + sum + "^2)*" + sum, p + "^3 - " + p + "*" + sum + "^2", "v*" + sum + "^2", sum + "^3"}));
  CHECK(summary(line) == "1 0 0 0 0 certified");
  REQUIRE(line.components.size() == 1);
  const SurfaceComponent& curve = line.components[0];
  CHECK(length_of(curve) == doctest::Approx(1.0 / 3));
  for (const SurfacePoint& at : curve.points) {
    const auto& [u, v, s, t] = at.parameters;
    CHECK(std::fabs(std::fabs(4 * u + v - 2) - 1) < 1e-11);
    CHECK(std::fabs(4 * u + v - 2 + 4 * s + t - 2) < 1e-11);
    CHECK(std::fabs(v - t) < 1e-11);
  }
  const bool first_is_right = curve.points.front().parameters[0] > curve.points.front().parameters[2];
  for (const BranchEnd* end : {&curve.start, &curve.end}) {
    const bool below = end->side[1] == -1;
    CHECK(end->side == (below ? std::array{0, -1, 0, -1} : std::array{0, 0, 0, 0}));
    CHECK(end->third_side == std::array{!below && first_is_right, !below && !first_is_right});
  }
  const std::string weight = "(1 - 3*v + 3*v^2)";
  const SurfaceResult weighted =
      with_itself({{patch({"(u^2 - 1)*" + weight, "(u^3 - u)*" + weight, "v*" + weight, weight},
                          {symbolic::Interval{ratio(-3, 2), ratio(3, 2)}, symbolic::Interval{0, 1}})}});
  CHECK(summary(weighted) == "1 0 0 0 0 certified");
  CHECK(length_of(weighted.components.at(0)) == doctest::Approx(1));
}
