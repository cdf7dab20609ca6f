// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/cylinder_layer.hpp>

#include <cmath>

namespace eliminant::numeric {

namespace {

// A surface that leaves the layer of points within the distance on both sides has sqrt(3) - 1 = 0.73 times as many
// beside it, up to three distances away; noise of which the distance is one standard deviation has 0.46 times as many.
constexpr double most_beside = 0.6;

}  // namespace

std::vector<NearPoint> points_near(std::span<const Point> points, const CylinderFrame& frame, double lowest,
                                   double highest, double distance) {
  std::vector<NearPoint> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [height, residual] = frame.at(points[i]);
    if (height >= lowest && height <= highest && std::abs(residual) <= 3 * distance)
      found.push_back({static_cast<std::uint32_t>(i), height, residual, std::abs(residual) <= distance});
  }
  return found;
}

bool ends_in_layer(std::size_t on, std::size_t beside) {
  return static_cast<double>(beside) <= most_beside * static_cast<double>(on);
}

double usual_count(std::span<const std::size_t> counts) {
  double sum = 0;
  double squares = 0;
  for (const std::size_t count : counts) {
    const auto number = static_cast<double>(count);
    sum += number;
    squares += number * number;
  }
  return sum > 0 ? squares / sum : 0;
}

}  // namespace eliminant::numeric
