// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <eliminant/numeric/cylinder_fit.hpp>
#include <eliminant/numeric/point_grid.hpp>
#include <eliminant/numeric/splitmix64.hpp>

namespace eliminant::numeric {

/// What counts as a cylinder in a cloud, in the unit of the points.
struct CylinderCriteria {
  /// Largest distance of a point from a cylinder that it lies on.
  double distance = 0;
  double min_radius = 0;
  double max_radius = 0;
  std::size_t min_inliers = 0;
};

/// A cylinder that many points of one ball lie on.
struct CylinderHypothesis {
  Cylinder cylinder;
  /// The center of the ball, and its radius.
  std::size_t seed = 0;
  double ball_radius = 0;
  /// How many of the points looked at in the ball lie on the cylinder.
  double share = 0;
};

/// The part of a ball's points that have to lie on a cylinder for it to become a hypothesis.
constexpr double least_local_share = 0.4;

/// One local sample: the point `seed` and four others of the ball of radius `grid.side()` around it, the cylinders
/// through these five, the best of them fitted to the points of the ball. Nothing when no cylinder of a radius between
/// a quarter and the double of the ball's, within the criteria, has `least_local_share` of the ball's points on it, or
/// when the surface goes on beside the cylinder, as a plane or a sphere does.
/// `points` are those of the grid. Source of the solver: [DevillersMourrainPreparataTrebuchet2003].
std::optional<CylinderHypothesis> sample_cylinder(std::span<const Point> points, const PointGrid& grid,
                                                  std::size_t seed, const CylinderCriteria& criteria,
                                                  SplitMix64& random);

}  // namespace eliminant::numeric
