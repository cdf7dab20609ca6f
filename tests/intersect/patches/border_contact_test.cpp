// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>

// Contacts on the borders of patches and on the seams of surfaces of several pieces.
using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::ParametricSurface;
using symbolic::Rational;

namespace {

SurfaceResult solved(const PatchText& first, const PatchText& second, const Sides& sides = unit_square()) {
  Options options;
  options.tolerance = 1e-6;
  return intersect_patches(patch(first), patch(second, sides), options, Context());
}

SurfaceResult solved(const ParametricSurface& first, const ParametricSurface& second) {
  Options options;
  options.tolerance = 1e-6;
  return intersect_surface_surface({first, second}, options, Context());
}

const Sides large{symbolic::Interval{-2, 2}, symbolic::Interval{-3, 2}};

ParametricSurface plane(const std::string& height) { return {{patch({"u", "v", height}, large)}}; }

/// z = f of pieces of x = u, y = v on the four quarters of [-1, 1]^2, in the order (-, -), (-, +), (+, -), (+, +).
ParametricSurface quarters(const std::array<std::string, 4>& heights) {
  const symbolic::Interval lower{-1, 0};
  const symbolic::Interval upper{0, 1};
  ParametricSurface surface;
  for (std::size_t i = 0; i < 4; ++i)
    surface.pieces.push_back(patch({"u", "v", heights[i]}, {i < 2 ? lower : upper, i % 2 == 0 ? lower : upper}));
  return surface;
}

ParametricSurface smooth(const std::string& height) { return quarters({height, height, height, height}); }

std::size_t ends_at_singular_points(const SurfaceResult& result) {
  std::size_t count = 0;
  for (const SurfaceComponent& component : result.components)
    for (const BranchEnd* end : {&component.start, &component.end})
      if (end->kind == BranchEndKind::singular) {
        REQUIRE(end->singular_point);
        REQUIRE(*end->singular_point < result.singular_points.size());
        ++count;
      }
  return count;
}

}  // namespace

TEST_CASE("Border contacts: a border that a branch crosses ends there, at rational and at algebraic parameters") {
  const Sides plane_sides{symbolic::Interval{-1, 2}, symbolic::Interval{-1, 2}};
  for (const auto& [factor, at] : std::vector<std::pair<std::string, double>>{
           {"(u - 1/2)", 0.5}, {"(u^2 - 1/2)", std::sqrt(0.5)}, {"(u^3 + u - 1)", 0.6823278038280193}})
    for (const bool exchanged : {false, true}) {
      CAPTURE(factor);
      CAPTURE(exchanged);
      const PatchText first{"u", "v", "v*" + factor};
      Options options;
      options.tolerance = 1e-6;
      const SurfaceResult result =
          exchanged ? intersect_patches(patch({"u", "v", "0"}, plane_sides), patch(first), options, Context())
                    : solved(first, {"u", "v", "0"}, plane_sides);
      CHECK(summary(result) == "3 0 0 0 1 certified");
      REQUIRE(result.singular_points.size() == 1);
      const SurfaceSingularPoint& crossing = result.singular_points[0];
      CHECK(crossing.kind == SurfaceSingularity::crossing);
      CHECK(crossing.half_branches == 3);
      CHECK(ends_at_singular_points(result) == 3);
      CHECK(crossing.at.point[0] == doctest::Approx(at).epsilon(1e-14));
      CHECK(crossing.at.point[1] == 0);
      double along_border = 0;
      for (const SurfaceComponent& curve : result.components) {
        CHECK(curve.certified);
        CHECK_FALSE(curve.tangential);
        CHECK(farthest(curve, [&](const SpacePoint& p) {
                return std::min(std::fabs(p[0] - at), std::fabs(p[1])) + std::fabs(p[2]);
              }) <= curve.error);
        if (std::fabs(curve.points.front().point[1] - curve.points.back().point[1]) < 1e-12)
          along_border += length_of(curve);
      }
      CHECK(along_border == doctest::Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("Border contacts: a border through an undecided contact is not certified") {
  // A branch touches the border from inside: contact of third order.
  const SurfaceResult result = solved({"u", "v", "v*(v - (u - 1/2)^2)"}, {"u", "v", "0"},
                                      {symbolic::Interval{-1, 2}, symbolic::Interval{-1, 2}});
  CHECK(result.status == Status::numeric);
  const auto border = std::find_if(result.components.begin(), result.components.end(), [](const auto& c) {
    return c.start.kind == BranchEndKind::border && c.end.kind == BranchEndKind::border;
  });
  REQUIRE(border != result.components.end());
  CHECK_FALSE(border->certified);
  CHECK(border->reason == "whether another branch crosses it is not proven");
}

TEST_CASE("Border contacts: points of their own on a side and in a corner of the domain") {
  const Sides plane_sides{symbolic::Interval{-1, 2}, symbolic::Interval{-1, 2}};
  for (const char* const height : {"u^2 + (v - 1/3)^2", "u^2 + v^2", "(u - 1)^2 + (v - 1)^2 + (u - 1)*(v - 1)",
                                   // Both arcs are outside of the domain.
                                   "(u + v)*(u + 2*v)"}) {
    CAPTURE(height);
    const SurfaceResult result = solved({"u", "v", height}, {"u", "v", "0"}, plane_sides);
    CHECK(summary(result) == "0 0 1 0 1 certified");
    REQUIRE(result.components.size() == 1);
    CHECK(result.components[0].tangential);
    REQUIRE(result.singular_points.size() == 1);
    CHECK(result.singular_points[0].kind == SurfaceSingularity::contact);
    CHECK(result.singular_points[0].half_branches == 0);
  }
}

TEST_CASE("Seams: a contact of a smooth surface on a seam, or where two cross, is one point") {
  for (const auto& [height, other] : std::vector<std::pair<std::string, std::string>>{
           {"u^2 + v^2", "0"}, {"u^2 + v^2", "2*v/3 - 1/9"}, {"u^2 + u*v + v^2", "u/2 + v - 1/4"}}) {
    CAPTURE(other);
    for (const bool exchanged : {false, true}) {
      const SurfaceResult result =
          exchanged ? solved(plane(other), smooth(height)) : solved(smooth(height), plane(other));
      CHECK(summary(result) == "0 0 1 0 1 certified");
    }
  }
}

TEST_CASE("Seams: branches that cross on a seam end in one crossing") {
  struct Case {
    std::string name;
    ParametricSurface surface;
    std::string height;
  };
  const std::vector<Case> cases{
      {"smooth, where seams cross", smooth("u^2 - v^2"), "0"},
      {"smooth, on one seam", smooth("u^2 - v^2"), "1/9 - 2*v/3"},
      {"along the seams", smooth("u*v"), "0"},
      {"kinked, along a seam", quarters({"u*v", "u*v", "3*u*v", "3*u*v"}), "0"},
      {"kinked, both touch", quarters({"u^2 - v^2", "u^2 - v^2", "4*u^2 - v^2", "4*u^2 - v^2"}), "0"},
      {"kinked, transversal", quarters({"v - u", "-u - v", "u + v", "u - v"}), "0"}};
  for (const Case& each : cases)
    for (const bool exchanged : {false, true}) {
      CAPTURE(each.name);
      CAPTURE(exchanged);
      const SurfaceResult result =
          exchanged ? solved(plane(each.height), each.surface) : solved(each.surface, plane(each.height));
      CHECK(summary(result) == "4 0 0 0 1 certified");
      REQUIRE(result.singular_points.size() == 1);
      CHECK(result.singular_points[0].kind == SurfaceSingularity::crossing);
      CHECK(result.singular_points[0].half_branches == 4);
      CHECK(ends_at_singular_points(result) == 4);
    }
}

TEST_CASE("Seams: a curve along a seam is cut where a branch of one side ends in it") {
  // For u < 0 the branch v = 0 ends in the seam u = 0, on the other side of which there is nothing else.
  const SurfaceResult result = solved(quarters({"u*v", "u*v", "u", "u"}), plane("0"));
  CHECK(summary(result) == "3 0 0 0 1 certified");
  REQUIRE(result.singular_points.size() == 1);
  CHECK(result.singular_points[0].half_branches == 3);
}

TEST_CASE("Seams: pieces of smoothly joined surfaces that meet in a corner alone are no doubt") {
  // A common border y = 0 with a seam at x = 1/2 across it, smooth to any order.
  const symbolic::Interval left{0, Rational(1) / Rational(2)};
  const symbolic::Interval right{Rational(1) / Rational(2), 1};
  const symbolic::Interval unit{0, 1};
  for (const char* const slope : {"v/3", "-v/3", "v^2"}) {
    CAPTURE(slope);
    const PatchText upper{"u", "v", "u - 3*u^2 + 2*u^3 + v/3"};
    const PatchText lower{"u", "-v", std::string("u - 3*u^2 + 2*u^3 + ") + slope};
    const SurfaceResult result = solved({{patch(upper, {left, unit}), patch(upper, {right, unit})}},
                                        {{patch(lower, {left, unit}), patch(lower, {right, unit})}});
    CHECK(summary(result) == "1 0 0 0 0 certified");
  }
}

TEST_CASE("A border that is one point: alone in the other surface it is a point, else branches end there") {
  // An octant of the unit sphere with its pole at u = 1.
  const PatchText octant{"(1 - u^2)*(1 - v^2)", "(1 - u^2)*2*v", "2*u*(1 + v^2)", "(1 + u^2)*(1 + v^2)"};
  struct Other {
    PatchText plane;
    bool tangential = false;
  };
  for (const Other& other :
       {Other{{"2*u - 1", "4*v - 2", "1"}, true}, Other{{"u - 1/4", "1/4 - u", "2*v"}}, Other{{"u", "v", "1 + u + v"}}})
    for (const bool exchanged : {false, true}) {
      CAPTURE(other.plane.x);
      const SurfaceResult result = exchanged ? solved(other.plane, octant) : solved(octant, other.plane);
      CHECK(summary(result) == "0 0 1 0 0 certified");
      REQUIRE(result.components.size() == 1);
      const SurfaceComponent& pole = result.components[0];
      CHECK(pole.tangential == other.tangential);
      REQUIRE(pole.points.size() == 1);
      const SurfacePoint& at = pole.points[0];
      CHECK(at.parameters[exchanged ? 2 : 0] == 1);
      // Every value of the other parameter has the point.
      CHECK(std::isnan(at.parameters[exchanged ? 3 : 1]));
      CHECK(pole.start.side[exchanged ? 2 : 0] == 1);
      CHECK(std::hypot(at.point[0], at.point[1], at.point[2] - 1) <= pole.error);
    }
  // The half of a meridian, and on a surface of which no inverse is known: that it ends in the pole is not proven.
  for (const bool plane : {true, false}) {
    CAPTURE(plane);
    const SurfaceResult meridian =
        solved(octant, {"u - 1/4", plane ? "2*u - 1/2" : "2*u - 1/2 + (u - 1/4)^2*(3*v - 1)^2/100", "3*v - 1"});
    CHECK((meridian.status == Status::certified) == plane);
    CHECK(meridian.counts.points == 0);
    REQUIRE(meridian.components.size() == 1);
    const SurfaceComponent& curve = meridian.components[0];
    CHECK(curve.kind == SurfaceComponentKind::curve);
    CHECK(curve.certified == plane);
    if (plane) CHECK(length_of(curve) == doctest::Approx(std::acos(0.0)).epsilon(1e-5));
    const bool at_end = curve.points.back().point[2] > 0.5;
    CHECK((at_end ? curve.end : curve.start).kind == BranchEndKind::border);
    CHECK((at_end ? curve.end : curve.start).side[0] == 1);
    CHECK((at_end ? curve.points.back() : curve.points.front()).point[2] == doctest::Approx(1).epsilon(1e-15));
  }
}
