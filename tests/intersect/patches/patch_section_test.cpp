// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/patch_section.hpp>

// Patches whose intersection is a curve F(Phi(u, v)) = 0 on one of them, with borders that are one point.
using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

/// An eighth of the unit sphere, v = 1 is its pole (0, 0, 1).
const PatchText octant{"(1-u^2)*(1-v^2)", "2*u*(1-v^2)", "2*v*(1+u^2)", "(1+u^2)*(1+v^2)"};
/// A quarter of the cone x^2 + y^2 = (1 - z)^2, v = 1 is its apex (0, 0, 1).
const PatchText cone{"(1-u^2)*(1-v)", "2*u*(1-v)", "v*(1+u^2)", "1+u^2"};

SurfaceResult solved(const PatchText& first, const PatchText& second) {
  Options options;
  options.tolerance = 1e-7;
  return intersect_patches(patch(first), patch(second), options, Context());
}

/// One certified curve from the tip (0, 0, 1) to another point.
void check_curve(const SurfaceResult& result, bool tangential, const SpacePoint& other_end, std::size_t border) {
  CHECK(result.status == Status::certified);
  CHECK(result.singular_points.empty());
  REQUIRE(result.components.size() == 1);
  SurfaceComponent curve = result.components[0];
  CHECK(curve.kind == SurfaceComponentKind::curve);
  CHECK(curve.certified);
  CHECK(curve.tangential == tangential);
  if (curve.points.front().point[2] < curve.points.back().point[2]) {
    std::reverse(curve.points.begin(), curve.points.end());
    std::swap(curve.start, curve.end);
  }
  CHECK(curve.start.side[border] == 1);
  const SpacePoint tip{0, 0, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(curve.points.front().point[k] == doctest::Approx(tip[k]).epsilon(1e-9));
    CHECK(curve.points.back().point[k] == doctest::Approx(other_end[k]).epsilon(1e-9));
  }
}

}  // namespace

TEST_CASE("Patch sections: a plane through the axis of a sphere or a cone, along a meridian at irrational parameters") {
  // y = x / 2, beyond the patches, and only as far as to the axis.
  for (const PatchText& plane : {PatchText{"4*u - 1", "2*u - 1/2", "4*v - 2"}, PatchText{"2*u", "u", "3*v - 1"}})
    for (const PatchText& round : {octant, cone}) {
      CAPTURE(plane.x);
      CAPTURE(round.z);
      const double x = std::sqrt(0.8);
      check_curve(solved(round, plane), false, {x, x / 2, 0}, 1);
      check_curve(solved(plane, round), false, {x, x / 2, 0}, 3);
    }
}

TEST_CASE("Patch sections: a plane through a pole, where the curve leaves the patch, is a point of its own") {
  // z = 1 - 2 x - y / 3: from (0, 3 / 5, 4 / 5) to z = 0, where 37 y^2 - 6 y = 27.
  const SurfaceResult result = solved(octant, {"4*u - 1", "4*v - 1/2", "1 - 2*(4*u - 1) - (4*v - 1/2)/3"});
  REQUIRE(summary(result) == "1 0 1 0 0 certified");
  const bool point_first = result.components[0].kind == SurfaceComponentKind::point;
  const SurfaceComponent& pole = result.components[point_first ? 0 : 1];
  const SurfaceComponent& curve = result.components[point_first ? 1 : 0];
  CHECK(std::isnan(pole.points[0].parameters[0]));
  CHECK(pole.points[0].parameters[1] == 1);
  CHECK(pole.points[0].parameters[2] == doctest::Approx(0.25).epsilon(1e-12));
  CHECK(pole.points[0].parameters[3] == doctest::Approx(0.125).epsilon(1e-12));
  CHECK(farthest(curve, [](const SpacePoint& p) {
          return std::fabs(std::hypot(p[0], p[1], p[2]) - 1) + std::fabs(p[2] - 1 + 2 * p[0] + p[1] / 3);
        }) <= 8 * curve.error);
  const double y = (3 + std::sqrt(1008.0)) / 37;
  for (const double end : {0.6, y})
    CHECK(std::min(std::fabs(curve.points.front().point[1] - end), std::fabs(curve.points.back().point[1] - end)) <
          1e-9);
}

TEST_CASE("Patch sections: a plane that touches a cone along a generator to its apex") {
  // 3 x + 4 y = 5 (1 - z).
  const PatchText plane{"3/5*(1 - v) + 4*(2*u - 1)", "4/5*(1 - v) - 3*(2*u - 1)", "v"};
  check_curve(solved(cone, plane), true, {0.6, 0.8, 0}, 1);
  check_curve(solved(plane, cone), true, {0.6, 0.8, 0}, 3);
}

TEST_CASE("Patch sections: none where curves cross, in one surface, and without inverses") {
  const auto section = [](const PatchText& first, const PatchText& second) {
    const NetPair nets(first, second);
    const std::array<symbolic::Rational, 3> origin{};
    return patch_section({nets.first, nets.second, nets.exact_first, nets.exact_second, origin}, 1e-6, 1, Context());
  };
  const PatchText plane{"u", "v", "0"};
  CHECK_FALSE(section({"u", "v", "(u - 1/2)*(v - 1/2)"}, plane));
  CHECK_FALSE(section({"u", "v", "(u - 1/2)^2 + (v - 1/2)^2"}, plane));
  CHECK_FALSE(section({"2*u", "v", "0"}, plane));
  CHECK_FALSE(section({"u", "v", "u^2*v^2 - 1/3"}, {"u", "v", "u^3 + v^3 - 1"}));
  const auto nothing = section({"u", "v", "1 + u*v"}, plane);
  REQUIRE(nothing);
  CHECK(nothing->arcs.empty());
  CHECK(nothing->points.empty());
  const auto circle = section({"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"}, plane);
  REQUIRE(circle);
  REQUIRE(circle->arcs.size() == 1);
  CHECK(circle->arcs[0].closed);
}

TEST_CASE("Patch sections: a curve that touches the other domain from outside is no section") {
  // z = 0 on the parabola y = c - (x - 1/2)^2; the plane begins at y = 0.
  const auto section = [](const std::string& c) {
    const NetPair nets({"u", "v - 1/2", "v - 1/2 + (u - 1/2)^2 - " + c}, {"u", "v", "0"});
    const std::array<symbolic::Rational, 3> origin{};
    return patch_section({nets.first, nets.second, nets.exact_first, nets.exact_second, origin}, 1e-6, 1, Context());
  };
  CHECK_FALSE(section("0"));
  REQUIRE(section("1/16"));
  CHECK(section("1/16")->arcs.size() == 1);
  REQUIRE(section("-1/16"));
  CHECK(section("-1/16")->arcs.empty());
}
