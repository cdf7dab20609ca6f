// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/columns.hpp>
#include <eliminant/bridge/nets/net_side.hpp>

namespace eliminant::bridge {

/// What was learnt of a pair of parts of two patches.
struct CellVerdict {
  /// They have no point in common.
  bool excluded = false;
  /// All of what they have in common is transversal, and moves along one direction of space: arcs that begin and end on
  /// the border of a part, no loop, no singular point.
  bool regular = false;
  /// Nearly parallel all over: the intersection may be singular.
  bool nearly_parallel = false;
};

/// Looks at pairs of parts of two patches.
///
/// Where both parts are graphs over one plane with gradients that differ in one direction m by an amount of one sign,
/// for all pairs of their points, the curve of intersection is monotone in the direction T orthogonal to m: a condition
/// on the normals as in [SederbergMeyers1988], sharper than two cones, and decided by bounds on control points.
class SurfaceCell {
 public:
  /// Their points are put into them one pair after the other, and bounded.
  Side<2> first;
  Side<2> second;

  bool apart() const {
    for (long k = 0; k < 3; ++k)
      if (first.box.upper[k] < second.box.lower[k] || second.box.upper[k] < first.box.lower[k]) return true;
    return false;
  }
  CellVerdict examine();
  /// How far the points of the parts are spread in space along u, v, s, t.
  std::array<double, 4> spreads() const;

 private:
  /// Directions of space in which both parts are looked at.
  struct Frame {
    /// Lanes: T, m, h, and the normal of the first; the normal of the second in all lanes.
    Columns lanes{Array4d::Zero(), Array4d::Zero(), Array4d::Zero()};
    Array4d second_normal = Array4d::Zero();
    bool has_direction = false;
  };

  bool frame_of_normals(Frame& frame) const;
  bool separated(const Frame& frame);
  /// Of a part as a graph of h over T and m: encloses the slope along m. False when it may be none.
  bool slope_bounds(const Side<2>& side, const std::vector<Array4d>& points, const Frame& frame,
                    DoubleInterval& slope) const;

  std::vector<Array4d> first_points_;
  std::vector<Array4d> second_points_;
};

}  // namespace eliminant::bridge
