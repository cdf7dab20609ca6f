// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/space_polyline.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::intersect {

double distance_from_segment(const std::array<double, 3>& a, const std::array<double, 3>& b,
                             const std::array<double, 3>& at) {
  double dot = 0;
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    dot += (at[k] - a[k]) * (b[k] - a[k]);
    square += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double place = square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
  double distance = 0;
  for (std::size_t k = 0; k < 3; ++k) distance = std::hypot(distance, at[k] - std::lerp(a[k], b[k], place));
  return distance;
}

double distance_in_space(const SurfaceComponent& component, const std::array<double, 3>& at) {
  double result = INFINITY;
  for (std::size_t i = 0; i + 1 < component.points.size(); ++i)
    result = std::min(result, distance_from_segment(component.points[i].point, component.points[i + 1].point, at));
  return result;
}

}  // namespace eliminant::intersect
