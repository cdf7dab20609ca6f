// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

struct SectionPoint {
  /// u, v in [0, 1].
  std::array<double, 2> parameters{};
  /// Affine coordinates of the patch there, in the coordinates of its net.
  std::array<double, 3> point{};
};

struct SectionArc {
  /// From the seed to the goal, or as far as it was followed.
  std::vector<SectionPoint> points;
  /// Bounds the distance in space of the polyline from the arc, and of the arc from the polyline; only if `proven`.
  double error = 0;
  bool proven = false;
};

/// What an arc ends in.
enum class SectionEnd {
  regular,   ///< a point at which the gradient of f is not zero
  node,      ///< a point where f and its gradient vanish, the Hessian indefinite
  singular,  ///< another point where f and its gradient vanish
  infinity   ///< the weight of the patch vanishes there
};

struct SectionSeed {
  std::array<double, 2> at{};
  /// Within that of it there are points of one arc alone, which is followed.
  double radius = 0;
  /// The arc is followed to that side.
  std::array<double, 2> side{};
};

struct SectionGoal {
  SectionEnd kind = SectionEnd::regular;
  std::array<double, 2> at{};
  /// Bounds the error of both parameters.
  double radius = 0;
  /// Along the arc the first parameter grows, or decreases, all the time.
  bool monotone = true;
};

/// Follows regular arcs of f(u, v) = 0 on a tensor-product patch by steps that are proven.
///
/// A step from x by d is right when for every m on the segment the system f(y) = 0, d (y - m) = 0 has exactly one
/// solution in a box around m: the contraction of y - C F(y) with one matrix C, from bounds on the second derivatives
/// of f. How far the arc is from the segment in the parameters, and in space, follows from that of the second and third
/// derivatives of f and the patch. Source: Krawczyk's test with a parameter, as for paths in [Krawczyk1969].
/// At a node both arcs stay in narrow double cones around the zero directions of the Hessian, as wide as the third
/// derivatives let them be, so that the distance to the chord is known there, too (Morse's lemma with bounds).
class SectionTracer {
 public:
  /// The weights of the patch are positive along the arcs that are followed. Both nets must outlive the object.
  SectionTracer(const ControlNet& patch, const ControlNet& function) : patch_(patch), function_(function) {}

  /// From a point of an arc to where it ends. `tolerance` is the distance allowed
  /// in space; points farther from the origin than `reach` need it only relative to their distance, and an arc to
  /// infinity is left beyond 100 times `reach`, beyond 1.5 times where doubles do not prove more.
  SectionArc trace(const SectionSeed& seed, const SectionGoal& goal, double tolerance, double reach,
                   const Context& context) const;

 private:
  const ControlNet& patch_;
  const ControlNet& function_;
};

}  // namespace eliminant::bridge
