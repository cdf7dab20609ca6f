// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <eliminant/bridge/nets/patch_jets.hpp>

namespace eliminant::bridge {

/// The difference F of two patches at parameters x = (u, v, s, t), in space.
struct Difference {
  Eigen::Vector4d x;
  Array4d value;
  /// Bounds that of each coordinate of the value.
  double error = 0;
  /// Rows are coordinates, the last one is 0; columns are u, v, s, t.
  Eigen::Matrix4d jacobian = Eigen::Matrix4d::Zero();
  PatchJets::Value first;
  PatchJets::Value second;

  /// Between the values of both patches, at a point that is taken for one of the curve.
  double at_most() const { return value.abs().head<3>().maxCoeff() + error; }
};

inline Eigen::Vector3d space_part(const Array4d& a) { return {a[0], a[1], a[2]}; }

/// By how much each parameter moves where the point in space moves by about one.
Eigen::Vector4d parameter_units(const Difference& here);

/// The difference of two patches as a map of four parameters, and its zeros near given points.
class PatchDifference {
 public:
  /// The nets must outlive the object.
  PatchDifference(const ControlNet& first, const ControlNet& second) : first_(first), second_(second) {}

  Difference at(const Eigen::Vector4d& x);
  /// Without second derivatives, which are left 0.
  Difference slopes_at(const Eigen::Vector4d& x);

  /// To the nearest point of the curve F = 0, by Newton's method; nothing is proven.
  Difference newton(Eigen::Vector4d x);

  const PatchJets& first() const { return first_; }
  const PatchJets& second() const { return second_; }

 private:
  Difference closest(Difference here);

  PatchJets first_;
  PatchJets second_;
};

}  // namespace eliminant::bridge
