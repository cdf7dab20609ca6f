// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/cylinder_sample.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <eliminant/numeric/cylinder_through_points.hpp>

namespace eliminant::numeric {

namespace {

// About a third of the points drawn from the cubes lie in the ball; a hundred tell shares of 0.4 from chance.
constexpr std::size_t draws = 256;
// Fewer points beside the five show nothing.
constexpr std::size_t least_points = 12;
// Noise in five points is larger in the cylinder through them.
constexpr double slack_of_five = 3;

struct Near {
  std::size_t on = 0;      ///< within the distance
  std::size_t beside = 0;  ///< further away, but within three times the distance
};

Near count_near(std::span<const Point> points, const Cylinder& cylinder, double distance) {
  const CylinderFrame frame(cylinder);
  Near near;
  for (const Point& point : points) {
    const double residual = std::abs(frame.at(point).residual);
    near.on += residual <= distance ? 1 : 0;
    near.beside += residual > distance && residual <= 3 * distance ? 1 : 0;
  }
  return near;
}

bool fits_ball(const Cylinder& cylinder, double ball_radius, const CylinderCriteria& criteria) {
  const double radius = cylinder.radius;
  return radius >= std::max(criteria.min_radius, ball_radius / 4) &&
         radius <= std::min(criteria.max_radius, 2 * ball_radius);
}

// The best of the cylinders through five points, fitted to the points near it.
std::optional<Cylinder> best_through(const std::array<Point, 5>& five, std::span<const Point> local, double ball_radius,
                                     const CylinderCriteria& criteria) {
  std::optional<Cylinder> best;
  std::size_t most = static_cast<std::size_t>(least_local_share * static_cast<double>(local.size()));
  for (const Cylinder& cylinder : real_cylinders_through(five)) {
    if (!fits_ball(cylinder, ball_radius, criteria)) continue;
    const std::size_t on = count_near(local, cylinder, slack_of_five * criteria.distance).on;
    if (on < most) continue;
    most = on;
    best = cylinder;
  }
  if (!best) return best;
  std::vector<Point> support;
  for (double reach = slack_of_five * criteria.distance; reach >= criteria.distance; reach /= slack_of_five) {
    const CylinderFrame frame(*best);
    support.clear();
    for (const Point& point : local)
      if (std::abs(frame.at(point).residual) <= reach) support.push_back(point);
    best = fit_cylinder(support, *best);
  }
  return best;
}

}  // namespace

std::optional<CylinderHypothesis> sample_cylinder(std::span<const Point> points, const PointGrid& grid,
                                                  std::size_t seed, const CylinderCriteria& criteria,
                                                  SplitMix64& random) {
  std::vector<std::uint32_t> ball;
  grid.sample_ball(seed, draws, random, ball);
  if (ball.size() < least_points) return std::nullopt;
  std::array<Point, 5> five{points[seed]};
  for (std::size_t i = 0; i < 4; ++i) {
    std::swap(ball[i], ball[i + random.below(ball.size() - i)]);
    five[i + 1] = points[ball[i]];
  }
  std::vector<Point> local(ball.size());
  std::transform(ball.begin(), ball.end(), local.begin(), [&](std::uint32_t i) { return points[i]; });
  const auto cylinder = best_through(five, local, grid.side(), criteria);
  if (!cylinder || !fits_ball(*cylinder, grid.side(), criteria)) return std::nullopt;
  const Near near = count_near(local, *cylinder, criteria.distance);
  const double share = static_cast<double>(near.on) / static_cast<double>(local.size());
  if (share < least_local_share || 2 * near.beside > near.on) return std::nullopt;
  return CylinderHypothesis{*cylinder, seed, grid.side(), share};
}

}  // namespace eliminant::numeric
