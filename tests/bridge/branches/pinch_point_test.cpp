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

TEST_CASE("Pinch point: pairs of rectangles away from the arc have no double points, those on it are not excluded") {
  // The umbrella with U = u + v^2/4 and V = v + v^2/8: double points have U = 0 and opposite V.
  const std::string big_u = "(u + v^2/4)";
  const std::string big_v = "(v + v^2/8)";
  const ControlNet net = in_doubles(patch_net({big_u + "*" + big_v, big_u, big_v + "^2"}, square(1)));
  const auto pinch = pinch_point_in(net, around(0.5, 0.5, 1.0 / 16));
  REQUIRE(pinch);
  const auto on_arc = [](double a) -> std::array<double, 2> {
    const double v = 4 * (std::sqrt(1 + a / 2) - 1);
    return {0.5 - v * v / 8, 0.5 + v / 2};
  };
  for (const double a : {0.002, 0.01, 0.03, 0.06})
    for (const double half : {1e-7, 1e-4, 1e-3}) {
      CAPTURE(a);
      CAPTURE(half);
      const auto [u, v] = on_arc(a);
      const auto [s, t] = on_arc(-a);
      const auto first = around(u, v, half);
      const auto second = around(s, t, half);
      CHECK_FALSE(is_off_arc(net, *pinch, first, second));
      CHECK_FALSE(is_off_arc(net, *pinch, second, first));
      if (half > a / 10) continue;
      // Both on one side of the pinch point, and beside the arc.
      CHECK(is_off_arc(net, *pinch, around(u, v + a / 2, half), around(s, t + a / 2, half)));
      CHECK(is_off_arc(net, *pinch, around(u + a / 4, v, half), around(s + a / 4, t, half)));
    }
}
