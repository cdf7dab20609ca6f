// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <eliminant/numeric/point_grid.hpp>
#include <vector>

using namespace eliminant::numeric;

namespace {

std::vector<Point> random_points(std::size_t count, double size) {
  SplitMix64 random(11);
  std::vector<Point> points(count);
  for (Point& point : points)
    for (double& x : point) x = size * (random.uniform() - 0.5);
  return points;
}

std::vector<std::uint32_t> ball_by_search(const std::vector<Point>& points, std::size_t center, double radius) {
  std::vector<std::uint32_t> ball;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double squares = 0;
    for (std::size_t k = 0; k < 3; ++k)
      squares += (points[i][k] - points[center][k]) * (points[i][k] - points[center][k]);
    if (i != center && squares <= radius * radius) ball.push_back(static_cast<std::uint32_t>(i));
  }
  return ball;
}

}  // namespace

TEST_CASE("PointGrid: with enough draws a ball holds exactly its points") {
  const auto points = random_points(400, 4);
  for (const double radius : {0.3, 1.0, 5.0}) {
    const PointGrid grid(points, radius);
    SplitMix64 random(1);
    std::vector<std::uint32_t> ball;
    for (std::size_t center = 0; center < points.size(); center += 7) {
      grid.sample_ball(center, 1000, random, ball);
      std::sort(ball.begin(), ball.end());
      CHECK(ball == ball_by_search(points, center, radius));
    }
  }
}

TEST_CASE("PointGrid: fewer draws give different points of the ball, each once, the same for the same seed") {
  const auto points = random_points(3000, 2);
  const PointGrid grid(points, 1);
  std::vector<std::uint32_t> ball;
  std::vector<std::uint32_t> again;
  SplitMix64 random(3);
  grid.sample_ball(5, 100, random, ball);
  SplitMix64 same(3);
  grid.sample_ball(5, 100, same, again);
  CHECK(ball == again);
  CHECK(ball.size() > 20);
  CHECK(ball.size() <= 100);
  CHECK(std::adjacent_find(ball.begin(), ball.end()) == ball.end());
  const auto all = ball_by_search(points, 5, 1);
  CHECK(std::includes(all.begin(), all.end(), ball.begin(), ball.end()));
}

TEST_CASE("PointGrid: points far out and equal points") {
  const std::vector<Point> points{{0, 0, 0}, {0, 0, 0}, {1e12, 1e12, 1e12}, {1e12, 1e12, 1e12}};
  const PointGrid grid(points, 1e-3);
  SplitMix64 random(1);
  std::vector<std::uint32_t> ball;
  grid.sample_ball(0, 10, random, ball);
  CHECK(ball == std::vector<std::uint32_t>{1});
  grid.sample_ball(2, 10, random, ball);
  CHECK(ball == std::vector<std::uint32_t>{3});
}
