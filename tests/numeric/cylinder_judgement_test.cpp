// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <eliminant/numeric/cylinder_judgement.hpp>
#include <functional>
#include <numbers>
#include <vector>

using namespace eliminant::numeric;

namespace {

constexpr double distance = 0.02;
constexpr double radius = 0.5;
constexpr double degree = std::numbers::pi / 180;

// Points of z = -2 to 2 above those of a plane curve, whose parameters are in degrees.
std::vector<Point> wall(const std::vector<double>& parameters, const std::function<Point(double)>& curve) {
  std::vector<Point> points;
  for (const double parameter : parameters)
    for (int k = -40; k <= 40; ++k) {
      Point point = curve(parameter);
      point[2] = k / 20.0;
      points.push_back(point);
    }
  return points;
}

std::vector<double> range(double first, double last, double step) {
  std::vector<double> numbers;
  for (int k = 0; first + k * step <= last; ++k) numbers.push_back(first + k * step);
  return numbers;
}

Point on_circle(double degrees) {
  return {radius * std::cos(degrees * degree), radius * std::sin(degrees * degree), 0};
}

// What is said of the cylinder of this radius around the z axis.
SegmentVerdict verdict(const std::vector<Point>& points, double around = radius) {
  CylinderSegment segment{{{0, 0, 1}, {0, 0, 0}, around}, -2, 2, distance, {}, 0};
  const CylinderFrame frame(segment.cylinder);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::abs(frame.at(points[i]).residual) <= distance) segment.inliers.push_back(static_cast<std::uint32_t>(i));
  return judge_segment(points, points, segment, {distance, 0.1, 2, 50});
}

}  // namespace

TEST_CASE("Judgement: arcs of a quarter and more are cylinders, shorter ones are narrow") {
  CHECK(verdict(wall(range(0, 359, 2), on_circle)) == SegmentVerdict::cylinder);
  CHECK(verdict(wall(range(10, 120, 2), on_circle)) == SegmentVerdict::cylinder);
  CHECK(verdict(wall(range(10, 60, 2), on_circle)) == SegmentVerdict::narrow);
}

TEST_CASE("Judgement: scan lines along the pipe may be two sectors apart, but within one arc") {
  CHECK(verdict(wall(range(5, 115, 22), on_circle)) == SegmentVerdict::cylinder);
  CHECK(verdict(wall(range(5, 185, 60), on_circle)) == SegmentVerdict::narrow);
  CHECK(verdict(wall({5, 27, 49, 185, 207, 229}, on_circle)) == SegmentVerdict::narrow);
}

TEST_CASE("Judgement: two planes that touch the circle are not round") {
  const auto both = wall(range(-60, 60, 1), [](double t) { return Point{radius - 0.01, radius * t / 60, 0}; });
  auto corner = wall(range(-60, 60, 1), [](double t) { return Point{radius * t / 60, radius - 0.01, 0}; });
  corner.insert(corner.end(), both.begin(), both.end());
  CHECK(verdict(corner) == SegmentVerdict::not_round);
}

TEST_CASE("Judgement: an ellipse is round as long as the circle has its points") {
  const auto ellipse = [](double ratio) {
    const double b = radius / std::sqrt(ratio);
    return wall(range(0, 359, 1), [=](double t) {
      return Point{ratio * b * std::cos(t * degree), b * std::sin(t * degree), 0};
    });
  };
  CHECK(verdict(ellipse(1.05)) == SegmentVerdict::cylinder);
  CHECK(verdict(ellipse(1.2)) == SegmentVerdict::beside);
  CHECK(verdict(ellipse(1.5)) == SegmentVerdict::narrow);
}

TEST_CASE("Judgement: a plane beneath a pipe changes nothing") {
  auto points = wall(range(0, 359, 2), on_circle);
  const auto floor = wall(range(-60, 60, 1), [](double t) { return Point{radius * t / 20, -radius, 0}; });
  points.insert(points.end(), floor.begin(), floor.end());
  CHECK(verdict(points) == SegmentVerdict::cylinder);
}

TEST_CASE("Judgement: points and radius are those asked for") {
  CHECK(verdict(wall({0, 90}, on_circle), 2.5) == SegmentVerdict::few_points);
  CHECK(verdict(wall(range(0, 359, 2),
                     [](double t) {
                       return Point{3 * std::cos(t * degree), 3 * std::sin(t * degree), 0};
                     }),
                3) == SegmentVerdict::radius);
  CHECK(verdict(wall(range(0, 359, 2),
                     [](double t) {
                       return Point{1.9 * std::cos(t * degree), 1.9 * std::sin(t * degree), 0};
                     }),
                1.9) == SegmentVerdict::cylinder);
}
