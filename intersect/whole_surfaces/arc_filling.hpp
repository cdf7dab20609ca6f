// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/intersect/whole_surfaces/branch_tube.hpp>

namespace eliminant::intersect {

/// A point of an arc of the intersection, and how far in space the chord from the point before it is from the arc.
struct ArcPoint {
  PointEnclosure point;
  double error = 0;
};

/// Bounds the distance in space between the arc of the tube from `start` to `end` and its chord; infinite where the
/// weight may be zero.
double chord_error(const SurfacePair& pair, const BranchTube& tube, const PointEnclosure& start,
                   const PointEnclosure& end);

/// Points of the arc of the tube behind `start`, up to `end`, whose chords are within `goal` of the arc where doubles
/// allow it. Each lies in the tube, which has one point for each value of its axis: no step leaves the arc.
std::vector<ArcPoint> fill_arc(const SurfacePair& pair, const BranchTube& tube, const PointEnclosure& start,
                               const PointEnclosure& end, double goal);

}  // namespace eliminant::intersect
