// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <eliminant/intersect/whole_surfaces/arc_filling.hpp>
#include <support/bezoutian_data.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using Coordinates = std::vector<std::string>;

TEST_CASE("Arc filling: points on a circle, chords as near to it as asked for") {
  // A cylinder about the axis of z and the plane z = 0.
  const auto cylinder =
      test::weight_first(Coordinates{"u^2 + 1", "1 - u^2", "2*u", "v*(u^2 + 1)"}, test::first_parameters());
  const auto plane = test::weight_first(Coordinates{"1", "s", "t", "0"}, test::second_parameters());
  const SurfacePair pair(cylinder, plane);
  BranchPoint centre{{}, {0, 0, 1, 0}};
  const auto tube = enclose_branch(pair, centre, 0, {1, 0, 0, 2}, DoubleInterval(-1e-9, 0.08));
  REQUIRE(tube);
  const auto start = enclose_branch_point(pair, centre, 0);
  BranchPoint ahead{{}, {0.0625, 0, 1, 0.125}};
  const auto end = enclose_branch_point(pair, ahead, 0);
  REQUIRE(start);
  REQUIRE(end);
  const double whole = chord_error(pair, *tube, *start, *end);
  CHECK(whole > 1e-3);
  for (const double goal : {1e-4, 1e-6, 1e-8}) {
    CAPTURE(goal);
    const std::vector<ArcPoint> points = fill_arc(pair, *tube, *start, *end, goal);
    CHECK(points.size() > 1);
    PointEnclosure before = *start;
    double angle_before = 0;
    for (const ArcPoint& next : points) {
      const double angle = 2 * std::atan(middle(next.point.box[0]));
      CHECK(angle > angle_before);
      CHECK(std::fabs(middle(next.point.box[2]) - std::cos(angle)) < 1e-14);
      CHECK(std::fabs(middle(next.point.box[3]) - std::sin(angle)) < 1e-14);
      // The height of the arc above its chord.
      CHECK(1 - std::cos((angle - angle_before) / 2) <= next.error);
      CHECK(next.error < 2 * goal);
      before = next.point;
      angle_before = angle;
    }
    CHECK(before.box[0].lower == end->box[0].lower);
  }
}

TEST_CASE("Arc filling: a goal beyond the accuracy of doubles ends where they do") {
  const auto cylinder =
      test::weight_first(Coordinates{"u^2 + 1", "1 - u^2", "2*u", "v*(u^2 + 1)"}, test::first_parameters());
  const auto plane = test::weight_first(Coordinates{"1", "s", "t", "0"}, test::second_parameters());
  const SurfacePair pair(cylinder, plane);
  BranchPoint centre{{}, {0, 0, 1, 0}};
  const auto tube = enclose_branch(pair, centre, 0, {1, 0, 0, 2}, DoubleInterval(-1e-9, 1e-3));
  const auto start = enclose_branch_point(pair, centre, 0);
  const auto end = enclose_branch_point(pair, {{}, {0x1p-10, 0, 1, 0x1p-9}}, 0);
  REQUIRE(tube);
  REQUIRE(start);
  REQUIRE(end);
  const std::vector<ArcPoint> points = fill_arc(pair, *tube, *start, *end, 0);
  CHECK(points.size() < 20100);
  for (const ArcPoint& next : points) CHECK(next.error < 1e-12);
}
