// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <eliminant/numeric/cylinder_fit.hpp>
#include <eliminant/numeric/splitmix64.hpp>
#include <numbers>
#include <vector>

using namespace eliminant::numeric;

namespace {

// Points of x^2 + y^2 = r^2, moved by `shift` and away from the surface by `noise`.
std::vector<Point> round_points(double radius, double height, const Point& shift, double noise, std::size_t count) {
  SplitMix64 random(5);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * random.uniform();
    const double r = radius + noise * (2 * random.uniform() - 1);
    points.push_back(
        {shift[0] + r * std::cos(turn), shift[1] + r * std::sin(turn), shift[2] + height * random.uniform()});
  }
  return points;
}

}  // namespace

TEST_CASE("CylinderFrame: heights, residuals and angles of known points") {
  const CylinderFrame frame({{0, 0, 2}, {1, 1, 5}, 3});
  CHECK(frame.at({1, 1, 7}).height == doctest::Approx(2));
  CHECK(frame.at({1, 1, 7}).residual == doctest::Approx(-3));
  CHECK(frame.at({6, 1, 5}).residual == doctest::Approx(2));
  CHECK(frame.at({1, 4, -1}).residual == doctest::Approx(0));
  CHECK(frame.at({1, 4, -1}).height == doctest::Approx(-6));
  const double quarter =
      std::abs(std::remainder(frame.angle({2, 1, 0}) - frame.angle({1, 2, 9}), 2 * std::numbers::pi));
  CHECK(quarter == doctest::Approx(std::numbers::pi / 2));
  const Point on_axis = frame.axis_at(-2);
  CHECK(on_axis[0] == doctest::Approx(1));
  CHECK(on_axis[1] == doctest::Approx(1));
  CHECK(on_axis[2] == doctest::Approx(3));
}

TEST_CASE("fit_cylinder: exact points give the cylinder back from a start that is off") {
  const auto points = round_points(2, 6, {10, -3, 1}, 0, 60);
  const Cylinder fitted = fit_cylinder(points, {{0.1, -0.1, 1}, {10.3, -2.8, 0}, 2.4});
  CHECK(fitted.radius == doctest::Approx(2).epsilon(1e-7));
  CHECK(std::abs(fitted.direction[2]) == doctest::Approx(1).epsilon(1e-12));
  const Point foot = CylinderFrame(fitted).axis_at(0);
  CHECK(foot[0] == doctest::Approx(10).epsilon(1e-7));
  CHECK(foot[1] == doctest::Approx(-3).epsilon(1e-7));
  CHECK(rms_distance(points, fitted) < 1e-7);
}

TEST_CASE("fit_cylinder: no cylinder near the least squares one has a smaller sum of squares") {
  const auto points = round_points(2, 6, {0, 0, 0}, 0.1, 400);
  const Cylinder fitted = fit_cylinder(points, {{0.05, 0, 1}, {0.1, 0, 0}, 2.1});
  const double least = rms_distance(points, fitted);
  CHECK(least > 0.05);
  CHECK(least < 0.06);  // 0.1 / sqrt(3) = 0.0577
  for (std::size_t k = 0; k < 3; ++k)
    for (const double change : {-1e-3, 1e-3}) {
      Cylinder other = fitted;
      other.axis_point[k] += change;
      CHECK(rms_distance(points, other) >= least * (1 - 1e-9));
      other = fitted;
      other.direction[k] += change;
      CHECK(rms_distance(points, other) >= least * (1 - 1e-9));
      other = fitted;
      other.radius += change;
      CHECK(rms_distance(points, other) > least);
    }
}

TEST_CASE("fit_cylinder: with fewer than five points the start stays") {
  const std::vector<Point> four{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Cylinder start{{0, 0, 1}, {3, 4, 5}, 6};
  const Cylinder fitted = fit_cylinder(four, start);
  CHECK(fitted.radius == 6);
  CHECK(fitted.axis_point == start.axis_point);
  CHECK(rms_distance({}, start) == 0);
}
