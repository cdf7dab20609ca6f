// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/intersect/overlaps/border_arc.hpp>
#include <eliminant/intersect/patches/net_patches.hpp>

namespace eliminant::intersect {

/// What two patches of one surface have in common. Each thing that is listed is proven.
struct PatchOverlap {
  /// Of the parts with an area: closed, counterclockwise in the parameters of the first patch.
  std::vector<DrawnCurve> outlines;
  /// Of the borders, beside these parts.
  std::vector<DrawnCurve> curves;
  std::vector<DrawnCurve> loops;
  std::vector<DrawnCurve> points;
  /// That is all, which is proven.
  bool complete = false;
};

/// Of two patches with positive weights. Two proofs that they are parts of one surface are tried: both are parts of one
/// map (shared_map), or both satisfy one equation of low degree (common_surface). nullopt when neither is found: they
/// may be parts of one surface nevertheless.
std::optional<PatchOverlap> patch_overlap(const PatchNets& first, const PatchNets& second, double tolerance,
                                          const Context& context);

}  // namespace eliminant::intersect
