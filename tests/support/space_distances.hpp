// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <support/power_patch.hpp>

/// Distances in space, in doubles.
namespace eliminant::test {

inline double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline double distance_to_segment(const std::array<double, 3>& p, const std::array<double, 3>& a,
                                  const std::array<double, 3>& b) {
  double along = 0;
  double length = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    length += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
  std::array<double, 3> foot;
  for (std::size_t k = 0; k < 3; ++k) foot[k] = a[k] + t * (b[k] - a[k]);
  return distance(p, foot);
}

/// An upper bound of the distance from the patch, by Gauss and Newton's iteration from parameters nearby.
inline double distance_to_patch(const std::array<double, 3>& p, const PowerPatch& patch, double u, double v) {
  double best = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 5; ++step) {
    const PowerPatch::Jet jet = patch.at(u, v);
    best = std::min(best, distance(p, {jet[0][0], jet[1][0], jet[2][0]}));
    double a = 0;
    double b = 0;
    double c = 0;
    double x = 0;
    double y = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double rest = p[k] - jet[k][0];
      a += jet[k][1] * jet[k][1];
      b += jet[k][1] * jet[k][2];
      c += jet[k][2] * jet[k][2];
      x += rest * jet[k][1];
      y += rest * jet[k][2];
    }
    const double determinant = a * c - b * b;
    if (!(determinant > 0)) break;
    u += (x * c - y * b) / determinant;
    v += (y * a - x * b) / determinant;
  }
  return best;
}

/// Of the largest coordinate of a control point.
inline double size_of(const ControlNet& net) {
  double size = 0;
  for (const auto& row : net)
    for (const auto& point : row)
      for (std::size_t k = 0; k < 3; ++k) size = std::max(size, std::abs(point[k] / point[3]));
  return size;
}

}  // namespace eliminant::test
