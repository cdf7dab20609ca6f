// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/thinned_polylines.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/intersect/patches/space_polyline.hpp>

namespace eliminant::intersect {

namespace {

std::size_t count_points(const SurfaceResult& result) {
  return std::accumulate(result.components.begin(), result.components.end(), std::size_t{0},
                         [](std::size_t sum, const SurfaceComponent& c) { return sum + c.points.size(); });
}

/// Two segments are replaced by one, all points of which are as near to them: the nearest points of the chord run
/// through all of it.
void halve(SurfaceComponent& component) {
  const std::vector<SurfacePoint>& all = component.points;
  std::vector<SurfacePoint> kept{all.front()};
  double farthest = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (i % 2 == 0 || i + 1 == all.size()) {
      kept.push_back(all[i]);
      continue;
    }
    farthest = std::max(farthest, distance_from_segment(all[i - 1].point, all[i + 1].point, all[i].point));
  }
  constexpr double rounding = 1 + 0x1p-40;
  component.error = (component.error + farthest) * rounding;
  component.points = std::move(kept);
}

}  // namespace

void thin_polylines(SurfaceResult& result, std::size_t most) {
  constexpr std::size_t least = 5;
  bool thinned = false;
  while (count_points(result) > most) {
    std::size_t longest = 0;
    for (const SurfaceComponent& component : result.components) longest = std::max(longest, component.points.size());
    if (longest < 2 * least) break;
    for (SurfaceComponent& component : result.components)
      if (2 * component.points.size() > longest) halve(component);
    thinned = true;
  }
  if (thinned)
    result.warnings.push_back("there are more than " + std::to_string(most) +
                              " points within the tolerance: polylines were thinned, their error says how far");
}

}  // namespace eliminant::intersect
