// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <support/branch_graphs.hpp>

#include <eliminant/bridge/branches/arc_tube.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using Eigen::Vector4d;
using eliminant::test::NetPair;

namespace {

constexpr double radius = 1.0 / 3;

/// The ground and a paraboloid, which meet in a circle around the middle.
struct Circle {
  NetPair nets{{"u", "v", "0"}, {"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"}};
  PatchDifference patches{nets.first, nets.second};

  DifferenceBounds everywhere() const {
    return {*patches.first().bounds_on(0, 1, 0, 1), *patches.second().bounds_on(0, 1, 0, 1), Vector4d::Zero(),
            Vector4d::Ones()};
  }
  /// `off` is how far from the circle.
  Difference at(double angle, double off = 0) {
    const double u = 0.5 + (radius + off) * std::cos(angle);
    const double v = 0.5 + (radius + off) * std::sin(angle);
    return patches.at({u, v, u, v});
  }
};

double distance(const Difference& point) {
  return std::fabs(std::hypot(point.first.point[0] - 0.5, point.first.point[1] - 0.5) - radius);
}

}  // namespace

TEST_CASE("Arc tube: the chord is as far from the circle as the deviation says, and not much nearer") {
  Circle circle;
  const DifferenceBounds bounds = circle.everywhere();
  for (const double angle : {1e-4, 1e-3, 1e-2, 1e-1}) {
    CAPTURE(angle);
    const Difference from = circle.at(1);
    const Difference to = circle.at(1 + angle);
    const ArcTube tube(circle.patches, bounds, from, to);
    REQUIRE(tube.proven());
    const double height = radius * (1 - std::cos(angle / 2));
    CHECK(tube.deviation() >= height);
    CHECK(tube.deviation() <= 1.5 * height + 1e-14);
  }
}

TEST_CASE("Arc tube: filled with as many points as a tolerance wants") {
  Circle circle;
  const DifferenceBounds bounds = circle.everywhere();
  const Difference from = circle.at(2);
  const Difference to = circle.at(2.1);
  const ArcTube tube(circle.patches, bounds, from, to);
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
    CAPTURE(tolerance);
    const auto filling = tube.fill(circle.patches, tolerance);
    REQUIRE(filling);
    CHECK(filling->deviation <= tolerance);
    // The chords that a circle needs, and half as many more at the most.
    const double needed = 0.1 / (2 * std::acos(1 - tolerance / radius));
    CHECK(static_cast<double>(filling->points.size()) + 1 >= std::floor(needed));
    CHECK(static_cast<double>(filling->points.size()) <= 1.5 * needed + 1);
    double before = 2;
    double widest = 0;
    for (const Difference& point : filling->points) {
      CHECK(distance(point) < 1e-14);
      const double angle = std::atan2(point.x[1] - 0.5, point.x[0] - 0.5);
      CHECK(angle > before);
      widest = std::max(widest, angle - before);
      before = angle;
    }
    widest = std::max(widest, 2.1 - before);
    CHECK(radius * (1 - std::cos(widest / 2)) <= filling->deviation);
  }
  // Below what doubles can tell.
  CHECK_FALSE(tube.fill(circle.patches, 1e-17));
}

TEST_CASE("Arc tube: nothing is proven across the circle, or where the bounds do not hold") {
  Circle circle;
  const DifferenceBounds bounds = circle.everywhere();
  const Difference from = circle.at(0);
  CHECK_FALSE(ArcTube(circle.patches, bounds, from, circle.at(std::numbers::pi)).proven());
  CHECK_FALSE(ArcTube(circle.patches, bounds, from, circle.at(std::numbers::pi)).fill(circle.patches, 1e-3));
  CHECK_FALSE(ArcTube(circle.patches, bounds, from, from).proven());
  DifferenceBounds narrow = bounds;
  narrow.upper[1] = 0.51;
  CHECK(ArcTube(circle.patches, bounds, from, circle.at(0.1)).proven());
  CHECK_FALSE(ArcTube(circle.patches, narrow, from, circle.at(0.1)).proven());
}

TEST_CASE("Arc tube: ends that are not quite on the arc make the deviation larger") {
  Circle circle;
  const DifferenceBounds bounds = circle.everywhere();
  const Difference from = circle.at(1, 1e-7);
  const Difference to = circle.at(1.001, -1e-7);
  const ArcTube tube(circle.patches, bounds, from, to);
  REQUIRE(tube.proven());
  CHECK(tube.deviation() >= 1e-7);
  CHECK_FALSE(tube.fill(circle.patches, 1e-8));
}
