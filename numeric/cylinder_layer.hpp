// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <eliminant/numeric/cylinder_fit.hpp>

namespace eliminant::numeric {

/// A point near a cylinder.
struct NearPoint {
  std::uint32_t index;
  double height;
  double residual;
  bool on;  ///< within the distance of the cylinder, or else only within three times the distance
};

/// The points within three times `distance` of the cylinder, between two heights, by increasing index.
std::vector<NearPoint> points_near(std::span<const Point> points, const CylinderFrame& frame, double lowest,
                                   double highest, double distance);

/// Whether a surface ends in the layer within the distance of a cylinder, by the number of its points there and that of
/// those beside it, up to three distances away.
bool ends_in_layer(std::size_t on, std::size_t beside);

/// The mean of the counts, each weighted by itself: what the counts are where most of the points are.
double usual_count(std::span<const std::size_t> counts);

}  // namespace eliminant::numeric
