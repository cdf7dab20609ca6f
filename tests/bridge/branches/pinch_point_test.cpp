// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/text_patches.hpp>

#include <eliminant/bridge/branches/pinch_point.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

const PatchText umbrella{"u*v", "u", "v^2"};

ParameterRectangle around(double u, double v, double half) { return {{u - half, v - half}, {u + half, v + half}}; }

void check_pinch(const ControlNet& net, const ParameterRectangle& rectangle, double u, double v, double angle) {
  const auto pinch = pinch_point_in(net, rectangle);
  REQUIRE(pinch);
  CHECK(pinch->radius < 1e-9);
  CHECK(std::fabs(pinch->parameters[0] - u) <= pinch->radius);
  CHECK(std::fabs(pinch->parameters[1] - v) <= pinch->radius);
  // A direction, not an orientation.
  CHECK(std::fabs(std::sin(pinch->angle - angle)) < 1e-9);
}

}  // namespace

TEST_CASE("Pinch point: of Whitney's umbrella, along v, on rectangles around it in any position") {
  const ControlNet net = in_doubles(patch_net(umbrella, square(1)));
  const double upright = std::acos(0.0);
  for (const double half : {0.125, 0.03125, 0x1p-10}) {
    check_pinch(net, around(0.5, 0.5, half), 0.5, 0.5, upright);
    check_pinch(net, around(0.5 + half / 3, 0.5 - half / 2, half), 0.5, 0.5, upright);
  }
}

TEST_CASE("Pinch point: of umbrellas moved by affine maps, with terms of higher order and weights") {
  const std::array<std::array<long, 4>, 4> affine{{{3, 1, 0, 10}, {-1, 2, 1, 0}, {0, 1, 4, -2}, {0, 0, 0, 5}}};
  const std::array<std::array<long, 4>, 4> projective{{{3, 1, 0, 1}, {-1, 2, 1, 0}, {0, 1, 4, 2}, {1, 1, 0, 8}}};
  const Sides sides{symbolic::Interval{-1, 2}, symbolic::Interval{-1, 1}};
  const double upright = std::acos(0.0);
  for (const PatchText& text : {umbrella, PatchText{"u*v + v^3/4", "u + u^2/8", "v^2 + u^3/8"}})
    for (const auto& map : {affine, projective}) {
      CAPTURE(text.x);
      ExactNet net = patch_net(text, sides);
      transform(net, map);
      check_pinch(in_doubles(net), around(1.0 / 3, 0.5, 1.0 / 64), 1.0 / 3, 0.5, upright);
    }
  // With u + v and u - v in place of u and v the direction is (1, -1).
  check_pinch(in_doubles(patch_net({"u^2 - v^2", "u + v", "(u - v)^2"}, square(1))), around(0.5, 0.5, 1.0 / 16), 0.5,
              0.5, -0.5 * upright);
}

TEST_CASE("Pinch point: an affine map of space takes nothing from what is proven") {
  const std::array<std::array<long, 4>, 4> turned{{{1, 2, 2, 7}, {2, 1, -2, 0}, {2, -2, 1, -5}, {0, 0, 0, 1}}};
  const std::array<std::array<long, 4>, 4> sheared{{{3, 1, 0, 10}, {-1, 2, 1, 0}, {0, 1, 4, -2}, {0, 0, 0, 5}}};
  const std::array<std::array<long, 4>, 4> stretched{{{20, 0, 1, 0}, {0, 1, 0, 3}, {0, 30, 1, 0}, {0, 0, 0, 1}}};
  for (const auto& map : {turned, sheared, stretched})
    for (const double half : {0.125, 0.25}) {
      ExactNet net = patch_net(umbrella, square(1));
      transform(net, map);
      check_pinch(in_doubles(net), around(0.5, 0.5, half), 0.5, 0.5, std::acos(0.0));
    }
}

TEST_CASE("Pinch point: only inside the rectangle, and one alone") {
  const ControlNet net = in_doubles(patch_net(umbrella, square(1)));
  CHECK_FALSE(pinch_point_in(net, around(0.75, 0.5, 0.125)));
  CHECK_FALSE(pinch_point_in(net, {{0.5, 0.375}, {0.625, 0.625}}));
  // Two of them, at u = 1/4 and -1/4.
  const ControlNet two = in_doubles(patch_net({"u", "v^2", "v*(u^2 - 1/16)"}, square(1)));
  CHECK_FALSE(pinch_point_in(two, around(0.5, 0.5, 0.25)));
  CHECK(pinch_point_in(two, around(0.375, 0.5, 1.0 / 64)));
  CHECK(pinch_point_in(two, around(0.625, 0.5, 1.0 / 64)));
}

TEST_CASE("Pinch point: not claimed of graphs, cuspidal edges and degenerate singular points") {
  for (const PatchText& text :
       {PatchText{"u", "v", "u*v"}, PatchText{"u", "v^2", "v^3"}, PatchText{"u^2", "u^3", "v"},
        PatchText{"u", "v^2", "v*(u^2 + v^2)"}, PatchText{"u", "v^2", "v*(u^2 - v^2)"}, PatchText{"u", "v^2", "v*u^2"},
        PatchText{"u^2", "u*v", "v^2"}, PatchText{"u", "v^2", "0"}})
    for (const double half : {0.125, 0x1p-7, 0x1p-14}) {
      CAPTURE(text.z);
      CAPTURE(half);
      CHECK_FALSE(pinch_point_in(in_doubles(patch_net(text, square(1))), around(0.5, 0.5, half)));
      CHECK_FALSE(pinch_point_in(in_doubles(patch_net(text, square(1))), around(0.5 + half / 5, 0.5 - half / 7, half)));
    }
}

TEST_CASE("Pinch point: the double points near it are within the reach, which falls with their distance") {
  const ControlNet net = in_doubles(patch_net(umbrella, square(1)));
  const auto pinch = pinch_point_in(net, around(0.5, 0.5, 0.125));
  REQUIRE(pinch);
  double last = INFINITY;
  for (double near = 0x1p-5; near > 0x1p-15; near *= 0.5) {
    CAPTURE(near);
    const auto reach = reach_of_pinch_point(net, *pinch, near);
    REQUIRE(reach);
    // (0, v) and (0, -v) are (0, 0, v^2), with |v| up to twice the local parameter.
    CHECK(*reach >= 4 * near * near);
    CHECK(*reach < 0.6 * last);
    last = *reach;
  }
  CHECK(last < 1e-7);
}
