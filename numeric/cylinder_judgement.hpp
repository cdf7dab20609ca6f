// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include <eliminant/numeric/cylinder_growth.hpp>

namespace eliminant::numeric {

/// Why a segment is no cylinder.
enum class SegmentVerdict {
  cylinder,
  few_points,  ///< fewer than asked for
  narrow,      ///< seen over less than a quarter of its circumference
  too_short,   ///< shorter than 1.5 radii
  curved,      ///< more points are on a surface whose axis bends or whose radius changes: torus, sphere, cone
  beside,      ///< the surface goes on beside the cylinder: plane
  not_round,   ///< more points are on a surface with another cross section: edge of a box, elliptic cylinder
  radius,      ///< outside the range asked for
};

/// Whether the segment is a cylinder, by its own points and those around it; the first reason that applies if not. Its
/// inliers are indices of `points`; `cloud` may have more points, those of surfaces that are known by now.
SegmentVerdict judge_segment(std::span<const Point> points, std::span<const Point> cloud,
                             const CylinderSegment& segment, const CylinderCriteria& criteria);

}  // namespace eliminant::numeric
