// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

struct TracedPoint {
  /// u, v, s, t in [0, 1].
  std::array<double, 4> parameters{};
  /// Affine coordinates of the first patch there, in the coordinates of the nets.
  std::array<double, 3> point{};
};

struct TracedArc {
  /// From one crossing point to the other.
  std::vector<TracedPoint> points;
  /// Bounds the distance in space of the polyline from the arc, and of the arc from the polyline; only if `proven`.
  double error = 0;
  /// Each of its segments is in a tube that holds exactly one smooth arc.
  bool proven = false;
};

/// Follows regular arcs of the intersection of two tensor-product patches with positive weights, by steps that are
/// proven.
///
/// With F the difference of both patches, a step from x by d is right when for every m on the segment the system
/// F(y) = 0, d (y - m) = 0 has exactly one solution in a box around it: the contraction of y - C F(y) with one matrix
/// C, from bounds on the second derivatives. That also bounds how far the arc is from the segment, in the parameters
/// and in space, by the square of |d|, so that the steps follow from the tolerance. Source: Krawczyk's test with a
/// parameter, as for paths in [Krawczyk1969].
class ArcTracer {
 public:
  /// The nets must outlive the object.
  ArcTracer(const ControlNet& first, const ControlNet& second);

  /// An arc in its cell; `tolerance` is the distance allowed in space.
  TracedArc trace(const CrossingPoint& from, const CrossingPoint& to, const CellBox& box, double tolerance,
                  const Context& context);

  /// From a point of an arc in the direction of another pair of parameters, until all differ from it by less than
  /// `near`.
  TracedArc trace_near(const std::array<double, 4>& from, const std::array<double, 4>& goal, const CellBox& box,
                       double near, double tolerance, const Context& context);

 private:
  const ControlNet& first_;
  const ControlNet& second_;
};

}  // namespace eliminant::bridge
