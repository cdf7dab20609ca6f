// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/bridge/contacts/contact_curve.hpp>
#include <eliminant/bridge/nets/ball_patch.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

namespace eliminant::bridge {

/// A point of the branch that crosses a curve of contact.
struct BranchPoint {
  /// u, v, s, t.
  std::array<double, 4> parameters{};
  /// Of the base, in the coordinates of its net.
  std::array<double, 3> point{};
  /// In the coordinates of the crossing.
  double x = 0;
  double y = 0;
  /// Bounds the error of x.
  double error = 0;
};

/// The branch that crosses a curve of contact, point by point.
///
/// Beside the curve the height h of one patch above the other is divided by the square of the distance from the curve;
/// the branch is where the quotient vanishes, whose derivative is known to be at least a sixth of the third one of h.
/// The height, of the third order in the distance from the crossing, is evaluated in balls.
class CrossingBranch {
 public:
  /// The curve must outlive the object.
  CrossingBranch(const ContactCurve& curve, const CurveCrossing& crossing);

  /// The point at a value y that is not 0, near `x`; nullopt where its error does not become less than `accuracy`.
  std::optional<BranchPoint> at(double x, double y, double accuracy);

 private:
  struct Quotient {
    double value = 0;
    double error = 0;
  };
  std::optional<Quotient> quotient_at(double x, double on_curve, BranchPoint& point);

  const ContactCurve& curve_;
  CurveCrossing crossing_;
  std::optional<ContactFrame> frame_;
  PatchJets base_;
  PatchJets other_;
  BallPatch ball_base_;
  BallPatch ball_other_;
  /// A bound of the factor between h with weights multiplied crosswise and in affine coordinates.
  double heaviest_ = 1;
  /// The last known change of the quotient by x.
  double slope_ = 0;
};

}  // namespace eliminant::bridge
