// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/intersect/result.hpp>

namespace eliminant::intersect {

/// A Bezier curve on [0, 1]: degree + 1 control points (w x, w y, w z, w), each number exactly what the double says. A
/// plane curve has z = 0.
struct BezierCurve {
  std::vector<bridge::HomogeneousPoint> points;
};

/// A tensor-product Bezier patch on [0, 1]^2 of that bidegree, the second index of the points running fastest.
struct BezierPatch {
  std::array<std::size_t, 2> degree{};
  std::vector<bridge::HomogeneousPoint> points;
};

/// A common point within the closed domains, in doubles.
struct BezierPoint {
  /// On the first curve, then on the second or on the patch (two); the rest is 0. Not numbers (NaN) on a patch none of
  /// whose parameters of the point could be proven: where a border of it is one point, or at a singular point.
  std::array<double, 3> parameters{};
  /// A bound of the error of each parameter; 0 where they are these numbers exactly.
  double radius = 0;
  /// The affine point of the curve there, rounded.
  std::array<double, 3> point{};
  /// Intersection multiplicity with the second curve or the patch near these parameters. Where the matrix engines did
  /// the work, with the whole surface of the patch, which may pass through the point again, also beyond its borders.
  unsigned long multiplicity = 1;
  /// The enclosure holds exactly one solution, of that multiplicity.
  bool certified = false;
};

struct BezierIntersections {
  /// certified: these are all, proven; infinite: a part in common, and isolated points; numeric; incomplete.
  Status status = Status::numeric;
  /// Sorted by their parameters.
  std::vector<BezierPoint> points;
  /// The intervals of the first curve's parameter that lie on the second, rounded.
  std::vector<std::array<double, 2>> overlap;
  /// True when hardware doubles proved everything; else the matrix engines did the work.
  bool by_boxes = false;
};

/// Intersects Bezier curves given in doubles with one patch, or with one plane curve, prepared once. The ordinary case
/// costs microseconds: subdivision with proven bounds on all roundings. Contacts at rational parameters are proven by
/// exact substitution; what remains goes to the matrix engines, in exact arithmetic. Many threads may use one object.
class BezierIntersector {
 public:
  /// Throws InvalidInput when the number of points does not fit the degree, a degree is 0, a number is not finite, all
  /// weights are 0 or (a curve) a z is not 0 or all points are one.
  explicit BezierIntersector(BezierPatch second);
  explicit BezierIntersector(BezierCurve second);

  /// Throws InvalidInput as the constructors do.
  BezierIntersections intersect(const BezierCurve& first, const Context& context = Context()) const;

 private:
  void prepare(const std::vector<std::size_t>& degrees, const std::vector<bridge::HomogeneousPoint>& points);
  BezierIntersections by_matrices(const BezierCurve& first, const Context& context) const;

  /// One of them.
  std::optional<BezierPatch> patch_;
  std::optional<BezierCurve> curve_;
  std::array<double, 3> origin_{};
  std::optional<bridge::ControlNet> net_;
};

}  // namespace eliminant::intersect
