// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <support/surface_checks.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::ParametricSurface;

namespace {

const Sides large{symbolic::Interval{-2, 2}, symbolic::Interval{-1, 3}};

ParametricSurface bounded(const PatchText& text, const Sides& sides = large) { return {{patch(text, sides)}}; }

ParametricSurface unbounded(const PatchText& text) {
  return {{{symbolic::RationalSurface(symbolic::RationalSurface::Kind::tensor_product, polynomials_of(text)), {}}}};
}

SurfaceResult solved(const ParametricSurface& first, const ParametricSurface& second, bool splines = false) {
  const Context context;
  Options options;
  options.tolerance = 1e-5;
  options.splines = splines;
  return intersect_surface_surface({first, second}, options, context);
}

/// Of both maps at the parameters of the points of a polyline from these points.
double largest_gap(const ParametricSurface& first, const ParametricSurface& second, const SurfaceComponent& component) {
  double largest = 0;
  for (const SurfacePoint& p : component.points)
    for (const std::size_t k : {0U, 1U}) {
      const double a = p.parameters[2 * k];
      const double b = p.parameters[2 * k + 1];
      // Poles and infinite parameters are not compared.
      if (!(std::fabs(a) < 1e3 && std::fabs(b) < 1e3)) continue;
      const auto& coordinates = (k == 0 ? first : second).pieces.front().map.coordinates();
      std::array<double, 4> value{};
      for (std::size_t i = 0; i < 4; ++i)
        for (const auto& term : coordinates[i].terms())
          value[i] += std::stod(term.coefficient.numerator().to_string()) /
                      std::stod(term.coefficient.denominator().to_string()) *
                      std::pow(a, static_cast<double>(term.exponents[0])) *
                      std::pow(b, static_cast<double>(term.exponents[1]));
      for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(value[i] / value[3] - p.point[i]));
    }
  return largest;
}

/// Of x^2 + y^2 = 1 and z = slope x + height.
CurveDistance ellipse(double slope, double height) {
  return [slope, height](const SpacePoint& p) {
    return std::max(std::fabs(std::hypot(p[0], p[1]) - 1),
                    std::fabs(p[2] - slope * p[0] - height) / std::hypot(1, slope));
  };
}

}  // namespace

TEST_CASE("Surfaces of several pieces: a half cylinder and a plane have one curve over the seam") {
  for (const double slope : {0.0, 0.5, -0.25})
    for (const bool exchanged : {false, true}) {
      const std::string height = slope == 0 ? "1" : slope > 0 ? "1 + u/2" : "1 - u/4";
      CAPTURE(height);
      const ParametricSurface plane = bounded({"u", "v", height});
      const SurfaceResult result = exchanged ? solved(plane, half_cylinder()) : solved(half_cylinder(), plane);
      CHECK(summary(result) == "1 0 0 0 0 certified");
      REQUIRE(result.components.size() == 1);
      const SurfaceComponent& curve = result.components[0];
      CHECK(curve.error < 1e-4);
      CHECK(farthest(curve, ellipse(slope, 1)) <= curve.error);
      if (slope == 0) CHECK(length_of(curve) == doctest::Approx(std::numbers::pi).epsilon(1e-4));
      // From the border u = 0 of the cylinder to u = 2.
      const std::size_t u = exchanged ? 2 : 0;
      const double begin = curve.points.front().parameters[u];
      CHECK(std::fabs(begin - (begin < 1 ? 0 : 2)) < 1e-12);
      CHECK(curve.points.back().parameters[u] == doctest::Approx(2 - begin));
      CHECK(std::abs(curve.start.side[u]) == 1);
      CHECK(curve.end.side[u] == -curve.start.side[u]);
    }
}

TEST_CASE("Surfaces of several pieces: a line along the seam is one curve, and one along a border goes over it") {
  const SurfaceResult seam = solved(half_cylinder(), bounded({"0*u", "u", "v"}));
  CHECK(summary(seam) == "1 0 0 0 0 certified");
  REQUIRE(seam.components.size() == 1);
  CHECK(length_of(seam.components[0]) == doctest::Approx(2));
  CHECK(seam.components[0].start.side == std::array{0, -1, 0, 0});
  CHECK(seam.components[0].end.side == std::array{0, 1, 0, 0});

  const SurfaceResult border = solved(half_cylinder(), bounded({"u", "v", "0"}));
  CHECK(summary(border) == "1 0 0 0 0 certified");
  REQUIRE(border.components.size() == 1);
  CHECK(length_of(border.components[0]) == doctest::Approx(std::numbers::pi).epsilon(1e-4));

  // The plane y = 0 meets it in its two outer borders.
  CHECK(summary(solved(half_cylinder(), bounded({"u", "0", "v"}))) == "2 0 0 0 0 certified");
  CHECK(summary(solved(half_cylinder(), bounded({"u", "-1/100", "v"}))) == "0 0 0 0 0 certified");
}

TEST_CASE("Surfaces of several pieces: a common point where all of them only touch") {
  // |u| + |v| and |u| + v^2 of four and two pieces, in one point of the plane z = 0.
  const auto half = [](long sign) { return symbolic::Interval{sign < 0 ? -1 : 0, sign < 0 ? 0 : 1}; };
  ParametricSurface pyramid;
  ParametricSurface ridge;
  for (const long p : {-1, 1}) {
    const std::string u = p < 0 ? "-u" : "u";
    ridge.pieces.push_back(patch({"u", "v", u + " + v^2"}, {half(p), symbolic::Interval{-1, 1}}));
    for (const long q : {-1, 1})
      pyramid.pieces.push_back(patch({"u", "v", u + (q < 0 ? " - v" : " + v")}, {half(p), half(q)}));
  }
  const ParametricSurface ground = bounded({"u", "v", "0"});
  CHECK(summary(solved(pyramid, ground)) == "0 0 1 0 0 certified");
  CHECK(summary(solved(ridge, ground)) == "0 0 1 0 0 certified");
  CHECK(summary(solved(ground, ridge)) == "0 0 1 0 0 certified");
  // Along its border it touches the plane.
  const SurfaceResult touching = solved(bounded({"u", "v", "u^2"}, {half(1), symbolic::Interval{-1, 1}}), ground);
  CHECK(summary(touching) == "1 0 0 0 0 certified");
  REQUIRE(touching.components.size() == 1);
  CHECK(touching.components[0].tangential);
}

TEST_CASE("A bounded surface against an unbounded one: a loop inside of a chart") {
  // At infinity the paraboloid has no points to compare: that is said, and nothing is certified of the whole.
  const SurfaceResult result = solved(bounded({"u", "v", "1/2"}, square(3)), unbounded({"u", "v", "u^2 + v^2"}));
  CHECK(result.status == Status::numeric);
  CHECK_FALSE(result.warnings.empty());
  CHECK(result.counts.loops == 1);
  CHECK(result.counts.curves == 0);
  REQUIRE(result.components.size() == 1);
  const SurfaceComponent& loop = result.components[0];
  CHECK(loop.certified);
  const double radius = std::sqrt(0.5);
  CHECK(farthest(loop, [&](const SpacePoint& p) { return std::hypot(std::hypot(p[0], p[1]) - radius, p[2] - 0.5); }) <=
        loop.error);
  CHECK(length_of(loop) == doctest::Approx(2 * std::numbers::pi * radius).epsilon(1e-4));
  for (const SurfacePoint& point : loop.points)
    for (std::size_t k = 0; k < 2; ++k) CHECK(std::fabs(point.parameters[2 + k] - point.point[k]) <= 1e-9);
}

TEST_CASE("A bounded surface against a whole torus: two loops over all of its charts") {
  // Radii 3 and 1, at the height 1/3: circles of radius 3 + and - sqrt(8 / 9).
  const ParametricSurface torus =
      unbounded({"(4 + 2*u^2)*(1 - v^2)", "(4 + 2*u^2)*2*v", "2*u*(1 + v^2)", "(1 + u^2)*(1 + v^2)"});
  for (const bool exchanged : {false, true}) {
    const ParametricSurface plane = bounded({"5*u", "5*v", "1/3"}, square(1));
    const SurfaceResult result = exchanged ? solved(plane, torus) : solved(torus, plane);
    CHECK(summary(result) == "0 2 0 0 0 certified");
    REQUIRE(result.components.size() == 2);
    double lengths = 0;
    for (const SurfaceComponent& loop : result.components) {
      lengths += length_of(loop);
      CHECK(farthest(loop, [](const SpacePoint& p) {
              return std::hypot(std::fabs(std::hypot(p[0], p[1]) - 3) - std::sqrt(8.0 / 9), p[2] - 1.0 / 3);
            }) <= loop.error);
    }
    CHECK(lengths == doctest::Approx(2 * std::numbers::pi * 6).epsilon(1e-4));
  }
  CHECK(summary(solved(torus, bounded({"5*u", "5*v", "2"}, square(1)))) == "0 0 0 0 0 certified");
}

TEST_CASE("Splines are fitted on request, with their error") {
  const SurfaceResult plain = solved(half_cylinder(), bounded({"u", "v", "1 + u/2"}));
  CHECK_FALSE(plain.components.at(0).spline.has_value());
  const SurfaceResult fitted = solved(half_cylinder(), bounded({"u", "v", "1 + u/2"}), true);
  REQUIRE(fitted.components.at(0).spline.has_value());
  CHECK(fitted.components[0].spline->error >= fitted.components[0].error);
  CHECK(fitted.components[0].spline->control_points.size() < fitted.components[0].points.size());
}

TEST_CASE("Two equations, and three homogeneous parameters without a domain, are refused") {
  const Context context;
  const std::vector<std::string> names{"x", "y", "z"};
  const symbolic::Polynomial sphere = symbolic::parse_polynomial("x^2 + y^2 + z^2 - 1", names);
  CHECK_THROWS_AS(intersect_surface_surface({sphere, sphere}, {}, context), InvalidInput);
  ParametricSurface projective{{symbolic::bezier_triangle(1, {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}})}};
  projective.pieces.front().region.reset();
  CHECK_THROWS_AS(intersect_surface_surface({half_cylinder(), projective}, {}, context), InvalidInput);
  CHECK_THROWS_AS(intersect_surface_with_itself({projective}, {}, context), InvalidInput);
  CHECK_THROWS_AS(intersect_surface_surface({bounded({"u", "u", "u"}), half_cylinder()}, {}, context), InvalidInput);
}

TEST_CASE("Whole surfaces with linear inverses: known curves, drawn to the tolerance, in either order") {
  const PatchText sphere{"2*v*(1-u^2)", "4*u*v", "(1-v^2)*(u^2+1)", "(u^2+1)*(v^2+1)"};
  const PatchText stereographic{"2*u", "2*v", "u^2+v^2-1", "u^2+v^2+1"};
  const PatchText shifted{"u^2/2 + 2*u + v^2/2 + 1/2", "u^2/3 + v^2/3 + 2*v + 1/3", "6*u^2/5 + 6*v^2/5 - 4/5",
                          "u^2+v^2+1"};
  const PatchText cylinder{"1-u^2", "2*u", "v*(u^2+1)", "u^2+1"};
  const PatchText thin{"1", "u", "v*(u^2+1)", "u^2+1"};
  const PatchText cone{"v*(1-u^2)", "2*u*v", "v*(u^2+1)", "u^2+1"};
  const PatchText torus{"(1-u^2)*(8*v^2+2)", "2*u*(8*v^2+2)", "6*v*(u^2+1)", "(u^2+1)*(v^2+1)"};
  struct Case {
    const char* name;
    PatchText first;
    PatchText second;
    const char* expected;
  };
  const std::vector<Case> cases{
      {"spheres through whose common circle no pole passes", stereographic, shifted, "0 1 0 0 0 certified"},
      {"Viviani's curve, each point of it twice on the sphere", sphere, thin, "4 0 0 0 2 certified"},
      {"cylinders of one radius", cylinder, {"v*(u^2+1)", "1-u^2", "2*u", "u^2+1"}, "4 0 0 0 2 certified"},
      {"Villarceau's circles", torus, {"u", "v", "3*u/4", "1"}, "4 0 0 0 2 certified"},
      {"an ellipse on a cone, apart from the apex", cone, {"u", "v", "u/2 + 1", "1"}, "0 1 0 0 0 certified"},
  };
  for (const Case& c : cases)
    for (const bool exchanged : {false, true}) {
      CAPTURE(c.name);
      CAPTURE(exchanged);
      const ParametricSurface a = unbounded(exchanged ? c.second : c.first);
      const ParametricSurface b = unbounded(exchanged ? c.first : c.second);
      const SurfaceResult result = solved(a, b);
      CHECK(summary(result) == c.expected);
      CHECK(result.engine.method == "equation");
      REQUIRE(result.projection);
      for (const SurfaceComponent& component : result.components) {
        CHECK(component.error <= 1e-4);
        // Vertices are that near to the curve, not to both surfaces.
        CHECK(largest_gap(a, b, component) <= component.error);
      }
    }
}
