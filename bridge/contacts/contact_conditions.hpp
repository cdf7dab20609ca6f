// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <eliminant/bridge/nets/patch_jets.hpp>

namespace eliminant::bridge {

/// What vanishes where two patches touch, in doubles: the derivatives of the first by u and v along the normal of the
/// second, and the difference of the points along the derivatives of the second by s and t.
struct ContactConditions {
  Eigen::Vector4d value;
  /// By u, v, s, t.
  Eigen::Matrix4d jacobian;
  /// Of the two points along the unit normal of the second.
  double gap = 0;
};

/// At (u, v) on the first and (s, t) on the second.
ContactConditions contact_conditions(PatchJets& first, PatchJets& second, const Eigen::Vector4d& at);

}  // namespace eliminant::bridge
