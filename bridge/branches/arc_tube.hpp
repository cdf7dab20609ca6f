// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include <eliminant/bridge/branches/patch_difference.hpp>

namespace eliminant::bridge {

/// Bounds of derivatives of both patches, and the box of parameters u, v, s, t where they hold.
struct DifferenceBounds {
  DerivativeBounds first;
  DerivativeBounds second;
  Eigen::Vector4d lower;
  Eigen::Vector4d upper;
};

/// A box around a step from one point of the curve F = 0 by d, in which a plane orthogonal to d (in the parameters,
/// each in its unit) meets the curve exactly once, for each plane between both ends: so the curve is one smooth arc
/// there, a function y of the share tau in [0, 1] of the way.
///
/// With A the Jacobian matrix of F and of the planes, and C the inverse of A at the beginning, y - C F(y) is
/// contracting in each plane. From A y' = (0, e) and A y'' = -(F''(y', y'), 0) come bounds of y' and y'' on all of the
/// arc, and so of its distance from any chord. Source: Krawczyk's test with a parameter, as for paths in
/// [Krawczyk1969].
class ArcTube {
 public:
  /// `here` and `next` are taken for points of the curve, which they need to be only within their errors. Not `proven`
  /// where the map is not contracting, or leaves the bounds.
  ArcTube(const PatchDifference& patches, const DifferenceBounds& bounds, const Difference& here,
          const Difference& next);

  bool proven() const { return contraction_ < 1; }
  /// How much of a distance the map leaves, at most.
  double contraction() const { return contraction_; }
  /// Bounds the distance in space between the arc and its chord; infinity when nothing is proven.
  double deviation() const { return deviation_; }

  /// Points of the arc, from the first one after `here` to the last one before `next`, such that the polyline with both
  /// ends is within a tolerance in space.
  struct Filling {
    std::vector<Difference> points;
    double deviation = 0;
    /// How many of the chords are there only because the bend may change within the tube.
    double spare = 0;
  };
  /// Nullopt where that cannot be proven.
  std::optional<Filling> fill(PatchDifference& patches, double tolerance) const;

 private:
  /// Bounds by how much the Jacobian matrix, in units of the parameters, changes from `here` to points within `reach`.
  struct JacobianChange {
    Eigen::Matrix<double, 3, 4> plain;
    /// Of its product with the inverse: where the patches are nearly tangent a column changes mostly along itself,
    /// which the product of absolute values does not tell.
    Eigen::Matrix4d solved;
  };
  JacobianChange change_of_jacobian() const;
  void bound_deviation();
  Eigen::Vector3d change_of_bend(const Eigen::Vector4d& along, const Eigen::Vector4d& error, std::size_t patch) const;
  struct Bend {
    double at_begin;
    double at_most;
  };
  std::optional<Bend> bend_across() const;
  /// A point of the arc, by Newton steps in its plane, and how far it may be from the exact one.
  struct Placed {
    Difference at;
    double error;
  };
  std::optional<Placed> place(PatchDifference& patches, const Eigen::Vector4d& guess) const;

  const DifferenceBounds& bounds_;
  const Difference& here_;
  const Difference& next_;
  /// In parameters, and in units.
  Eigen::Vector4d d_;
  Eigen::Vector4d unit_;
  Eigen::Vector4d step_;
  double scale_ = 0;
  Eigen::Matrix4d inverse_;
  Eigen::Vector4d steepness_;
  double point_error_ = 0;
  double rounding_ = 0;
  Eigen::Vector4d reach_;
  Eigen::Vector4d lower_;
  Eigen::Vector4d upper_;
  JacobianChange change_;
  double contraction_ = infinity;
  double deviation_ = infinity;
  /// Times the value of F at a point: bounds its distance from the arc in its plane, in units and in space.
  double distance_factor_ = infinity;
  double error_factor_ = infinity;
};

}  // namespace eliminant::bridge
