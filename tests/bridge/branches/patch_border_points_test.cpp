// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <support/branch_graphs.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

const PatchText ground{"u", "v", "0"};

/// The plane z = 0 far beyond the unit square: x = -1 to 2, y = -1 to 2.
const PatchText wide_ground{"3*u - 1", "3*v - 1", "0"};

struct Expected {
  std::array<double, 4> parameters;
  std::array<int, 4> side;
  unsigned arcs = 1;
  bool touching = false;
};

void check_points(const BorderPoints& found, const std::vector<Expected>& expected) {
  CHECK(found.open.empty());
  CHECK(found.points.size() == expected.size());
  for (const Expected& e : expected) {
    CAPTURE(e.parameters[0]);
    CAPTURE(e.parameters[1]);
    std::size_t matches = 0;
    for (const BorderPoint& point : found.points) {
      bool here = true;
      for (std::size_t k = 0; k < 4; ++k)
        here = here && std::fabs(point.parameters[k] - e.parameters[k]) <= point.radius + 1e-15;
      if (!here) continue;
      ++matches;
      CHECK(point.radius < 1e-9);
      CHECK(point.side == e.side);
      CHECK(point.arcs == e.arcs);
      CHECK(point.touching == e.touching);
      for (std::size_t k = 0; k < 4; ++k)
        if (e.side[k] != 0) CHECK(point.parameters[k] == (e.side[k] < 0 ? 0 : 1));
    }
    CHECK(matches == 1);
  }
}

}  // namespace

TEST_CASE("Border points: where arcs leave one patch, or both at once") {
  check_points(border_points(NetPair({"u", "v", "u - 1/3"}, wide_ground)),
               {{{1.0 / 3, 0, 4.0 / 9, 1.0 / 3}, {0, -1, 0, 0}}, {{1.0 / 3, 1, 4.0 / 9, 2.0 / 3}, {0, 1, 0, 0}}});
  check_points(border_points(NetPair(wide_ground, {"u", "v", "u - 1/3"})),
               {{{4.0 / 9, 1.0 / 3, 1.0 / 3, 0}, {0, 0, 0, -1}}, {{4.0 / 9, 2.0 / 3, 1.0 / 3, 1}, {0, 0, 0, 1}}});
  check_points(border_points(NetPair(ground, {"u", "v", "u - 1/3"})),
               {{{1.0 / 3, 0, 1.0 / 3, 0}, {0, -1, 0, -1}}, {{1.0 / 3, 1, 1.0 / 3, 1}, {0, 1, 0, 1}}});
  // Half of the arc is beyond the other patch.
  check_points(border_points(NetPair(ground, {"u", "v + 1/2", "u - 1/3"})),
               {{{1.0 / 3, 0.5, 1.0 / 3, 0}, {0, 0, 0, -1}}, {{1.0 / 3, 1, 1.0 / 3, 0.5}, {0, 1, 0, 0}}});
  CHECK(border_points(NetPair(wide_ground, {"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"})).points.empty());
  CHECK(border_points(NetPair(wide_ground, {"u", "v", "u + v + 1"})).points.empty());
}

TEST_CASE("Border points: corners in common, with an arc through them or alone") {
  const std::array<int, 4> origin{-1, -1, -1, -1};
  check_points(border_points(NetPair(ground, {"u", "v", "u - v"})),
               {{{0, 0, 0, 0}, origin}, {{1, 1, 1, 1}, {1, 1, 1, 1}}});
  check_points(border_points(NetPair(ground, {"u", "v", "u + v"})), {{{0, 0, 0, 0}, origin, 0}});
  check_points(border_points(NetPair(ground, {"u", "v", "u + v - 2"})), {{{1, 1, 1, 1}, {1, 1, 1, 1}, 0}});
  // The corner of one on the border of the other, and inside of it.
  check_points(border_points(NetPair(wide_ground, {"u", "v", "u + 2*v"})),
               {{{1.0 / 3, 1.0 / 3, 0, 0}, {0, 0, -1, -1}, 0}});
  check_points(border_points(NetPair({"u", "v - 1/2", "0"}, {"u", "v", "u + 2*v"})),
               {{{0, 0.5, 0, 0}, {-1, 0, -1, -1}, 0}});
}

TEST_CASE("Border points: arcs that touch a border from inside and from outside") {
  // y = (x - 1/2)^2 and y = -(x - 1/2)^2 on z = 0, where the border is y = 0.
  check_points(border_points(NetPair({"u", "v", "v - (u - 1/2)^2"}, wide_ground)),
               {{{0.5, 0, 0.5, 1.0 / 3}, {0, -1, 0, 0}, 2, true},
                {{0, 0.25, 1.0 / 3, 1.25 / 3}, {-1, 0, 0, 0}},
                {{1, 0.25, 2.0 / 3, 1.25 / 3}, {1, 0, 0, 0}}});
  check_points(border_points(NetPair({"u", "v", "v + (u - 1/2)^2"}, wide_ground)),
               {{{0.5, 0, 0.5, 1.0 / 3}, {0, -1, 0, 0}, 0, true}});
  // On the upper border of the second patch, at a third.
  check_points(border_points(NetPair(wide_ground, {"v", "u", "v - 1 + (u - 1/3)^2"})),
               {{{2.0 / 3, 4.0 / 9, 1.0 / 3, 1}, {0, 0, 0, 1}, 2, true},
                {{(1 + 8.0 / 9) / 3, 1.0 / 3, 0, 8.0 / 9}, {0, 0, -1, 0}},
                {{(1 + 5.0 / 9) / 3, 2.0 / 3, 1, 5.0 / 9}, {0, 0, 1, 0}}});
  check_points(border_points(NetPair(wide_ground, {"v", "u", "1 - v + (u - 1/3)^2"})),
               {{{2.0 / 3, 4.0 / 9, 1.0 / 3, 1}, {0, 0, 0, 1}, 0, true}});
}

TEST_CASE("Border points: an irrational corner on two border curves in one plane is decided without meetings") {
  // z = x^2 and z = 1/2 over y = 0: x = sqrt(1/2).
  const double root = std::sqrt(0.5);
  const PatchText parabola{"u", "v", "u^2"};
  check_points(border_points(NetPair(parabola, {"u", "v", "1/2"})),
               {{{root, 0, root, 0}, {0, -1, 0, -1}}, {{root, 1, root, 1}, {0, 1, 0, 1}}});
  // Patches on both sides of the plane have only that point in common.
  check_points(border_points(NetPair(parabola, {"u", "-v", "1/2"})), {{{root, 0, root, 0}, {0, -1, 0, -1}, 0}});
  // However high the degree: bounds on a box as small as the error of the point would be bounds of roundings.
  check_points(border_points(NetPair(parabola, {"u", "v", "1/2 + v*(1 - v)*(u^5*v^3 - u)/16"})),
               {{{root, 0, root, 0}, {0, -1, 0, -1}}, {{root, 1, root, 1}, {0, 1, 0, 1}}});
}

TEST_CASE("Border points: other irrational corners are asked for, and left open without an answer") {
  // The twisted cubic (u, u^3, u^2) and the line (u, u/2, 1/2) meet at u = sqrt(1/2).
  const NetPair nets({"u", "u^3 + v", "u^2"}, {"u", "u/2 + v", "1/2"});
  const Context context;
  std::size_t asked = 0;
  const auto no_parts = [](std::size_t, int) { return ContainedParts(); };
  const double root = std::sqrt(0.5);
  const auto with = [&](bool answered) {
    return patch_border_points(
        nets.first, nets.second, nets.exact_first, nets.exact_second,
        [&](std::size_t first_axis, int first_side, std::size_t second_axis, int second_side) {
          ++asked;
          std::vector<std::array<double, 2>> meetings;
          if (answered && first_axis == 1 && second_axis == 3 && first_side == second_side)
            meetings.push_back({root, root});
          return meetings;
        },
        no_parts, context);
  };
  const BorderPoints open = with(false);
  CHECK(asked > 0);
  CHECK_FALSE(open.open.empty());
  const BorderPoints decided = with(true);
  check_points(decided, {{{root, 0, root, 0}, {0, -1, 0, -1}}, {{root, 1, root, 1}, {0, 1, 0, 1}}});
}

TEST_CASE("Border points: border curves in the other patch are listed as contained, with nothing on them") {
  // Planes that meet along x = 0, a border of both.
  const NetPair nets(ground, {"u", "v", "u"});
  const Context context;
  const BorderPoints found = patch_border_points(
      nets.first, nets.second, nets.exact_first, nets.exact_second,
      [](std::size_t, int, std::size_t, int) { return std::vector<std::array<double, 2>>(); },
      [](std::size_t axis, int side) {
        ContainedParts parts;
        if (axis % 2 == 0 && side < 0) parts.intervals.push_back({0, 1});
        parts.nothing_else = !parts.intervals.empty();
        return parts;
      },
      context);
  CHECK(found.points.empty());
  CHECK(found.open.empty());
  REQUIRE(found.contained.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(found.contained[i].axis == 2 * i);
    CHECK(found.contained[i].side == -1);
    CHECK(found.contained[i].lower == 0);
    CHECK(found.contained[i].upper == 1);
  }
  // Not known to be contained, it is open.
  CHECK(border_points(nets).open.size() >= 2);
}
