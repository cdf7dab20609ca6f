// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <optional>

#include <support/text_patches.hpp>

#include <eliminant/intersect/patches/only_common_point.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

std::optional<CommonPoint> common(const PatchText& first, const PatchText& second) {
  const bridge::ExactNet a = patch_net(first);
  const bridge::ExactNet b = patch_net(second);
  const auto rounded_a = bridge::ControlNet::round(a.degrees, a.points, {});
  const auto rounded_b = bridge::ControlNet::round(b.degrees, b.points, {});
  REQUIRE(rounded_a);
  REQUIRE(rounded_b);
  return only_common_point({a, *rounded_a}, {b, *rounded_b});
}

using FourSides = std::array<int, 4>;

/// An octant of the unit sphere: u from the equator to the pole (0, 0, 1), v around.
const PatchText octant{"(1 - u^2)*(1 - v^2)", "(1 - u^2)*2*v", "2*u*(1 + v^2)", "(1 + u^2)*(1 + v^2)"};

}  // namespace

TEST_CASE("Only common point: the corner in which two patches meet, in either order") {
  const PatchText first{"u", "v", "u*v"};
  for (const PatchText& second : {PatchText{"1 + u", "1 + v", "1 + u + v + u*v"},
                                  PatchText{"(1 + u)*(1 + u)", "(1 - v)*(1 + u)", "1 + u", "1 + u"}}) {
    const auto point = common(first, second);
    const auto exchanged = common(second, first);
    REQUIRE(point);
    REQUIRE(exchanged);
    CHECK(point->side() == FourSides{1, 1, -1, -1});
    CHECK(exchanged->side() == FourSides{-1, -1, 1, 1});
  }
}

TEST_CASE("Only common point: not where patches have a border, another point or nothing in common") {
  const PatchText first{"u", "v", "0"};
  CHECK_FALSE(common(first, {"1 + u", "v", "u"}));
  CHECK_FALSE(common(first, {"2 + u", "v", "u"}));
  // From the corner back across the first.
  CHECK_FALSE(common(first, {"1 - u", "1 - v", "u - v"}));
  CHECK_FALSE(common(first, {"1 - u", "1 + v - 3*u*v", "u^2 + v - 2*v^2"}));
}

TEST_CASE("Only common point: a border that is one point, inside of the other patch, on its border and in its corner") {
  const PatchText tangent_plane{"2*u - 1", "4*v - 2", "1"};
  const PatchText plane_through{"u - 1/4", "1/4 - u", "2*v"};
  const PatchText corner{"u", "v", "1 + u + v"};
  for (const PatchText& other : {tangent_plane, plane_through, corner}) {
    CAPTURE(other.x);
    const auto point = common(octant, other);
    REQUIRE(point);
    CHECK(point->parameters[0] == symbolic::Rational(1));
    CHECK_FALSE(point->parameters[1]);
    REQUIRE(point->parameters[2]);
    REQUIRE(point->parameters[3]);
    const auto exchanged = common(other, octant);
    REQUIRE(exchanged);
    CHECK_FALSE(exchanged->parameters[3]);
    CHECK(exchanged->parameters[0] == point->parameters[2]);
  }
  // Both are one point there.
  const auto both = common(
      octant, {"(1 - u^2)*(1 - v^2)", "(1 - u^2)*2*v", "(1 + u^2)*(1 + v^2)*2 - 2*u*(1 + v^2)", "(1 + u^2)*(1 + v^2)"});
  REQUIRE(both);
  CHECK(both->side() == FourSides{1, 0, 1, 0});
  // A curve leads to the pole; the pole is beside the other.
  CHECK_FALSE(common(octant, {"u - 1/4", "u - 1/4", "2*v"}));
  CHECK_FALSE(common(octant, {"u + 1/4", "v", "1"}));
}

TEST_CASE("One point: borders of which all control points are one, whatever their weights") {
  const bridge::ExactNet net = patch_net(octant);
  CHECK(is_one_point(net, 0, 1));
  CHECK_FALSE(is_one_point(net, 0, -1));
  CHECK_FALSE(is_one_point(net, 1, 1));
  CHECK_FALSE(is_one_point(net, 1, -1));
}
