// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/point_exclusion.hpp>
#include <eliminant/bridge/enclosures/ball_surface.hpp>
#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>

namespace eliminant::intersect {

/// A tensor-product patch prepared for the box engine, or not where it is none.
class PatchBoxes {
 public:
  explicit PatchBoxes(const symbolic::SurfacePiece& piece);

  /// All solutions within both closed domains, proven and none missing; nullopt where the box engine cannot decide: no
  /// bounded domains, a contact at irrational parameters, a singular point, an irrational point on a border.
  std::optional<std::vector<CurveSolution>> solve(const symbolic::CurvePiece& curve, const Options& options,
                                                  const Context& context) const;

  /// True when the real point is proven to lie on no part of the patch.
  bool excludes(const std::vector<bridge::ComplexBall>& point, const Context& context) const;

 private:
  bridge::BallSurface surface_;
  std::optional<PreparedNet> prepared_;
  std::array<symbolic::Rational, 3> origin_;
  std::optional<bridge::ControlNet> net_;
};

}  // namespace eliminant::intersect
