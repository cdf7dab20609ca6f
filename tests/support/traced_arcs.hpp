// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <eliminant/bridge/branches/arc_tracing.hpp>

namespace eliminant::test {

/// The largest distance of a polyline from a curve, at its points and between them; `distance` is that of a point of
/// space.
template <class Distance>
double farthest(const bridge::TracedArc& arc, Distance distance) {
  double result = 0;
  for (std::size_t i = 0; i + 1 < arc.points.size(); ++i)
    for (int j = 0; j <= 4; ++j) {
      std::array<double, 3> at;
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = std::lerp(arc.points[i].point[k], arc.points[i + 1].point[k], 0.25 * j);
      result = std::max(result, distance(at));
    }
  return result;
}

}  // namespace eliminant::test
