// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <eliminant/numeric/cylinder_sample.hpp>

namespace eliminant::numeric {

/// A cylinder of finite length and the points on it.
struct CylinderSegment {
  Cylinder cylinder;
  /// Ends, as heights over the axis point in the direction.
  double lowest = 0;
  double highest = 0;
  /// Three and a half standard deviations of the noise, where that is less than the distance asked for: what the ends
  /// and the inliers were told by.
  double reach = 0;
  /// Indices of the points within `reach` between the ends, increasing.
  std::vector<std::uint32_t> inliers;
  double rms = 0;

  double length() const { return highest - lowest; }
};

/// The connected part of the cloud along the axis of `start` that contains the height of `seed`, the cylinder fitted
/// again and again to what has been found while it grows. A gap longer than the radius ends it.
CylinderSegment grow_cylinder(std::span<const Point> points, const Cylinder& start, const Point& seed,
                              double half_length, const CylinderCriteria& criteria);

}  // namespace eliminant::numeric
