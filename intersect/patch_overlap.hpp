// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/control_net.hpp>
#include <eliminant/intersect/border_arc.hpp>

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

/// Of two patches on [0, 1]^2; `first` and `second` are the exact nets in doubles, with one origin, weights positive.
/// Two proofs that they are parts of one surface are tried: both are parts of one map (shared_map), or both satisfy one
/// equation of low degree (common_surface). nullopt when neither is found: they may be parts of one surface
/// nevertheless.
std::optional<PatchOverlap> patch_overlap(const bridge::ExactNet& exact_first, const bridge::ExactNet& exact_second,
                                          const bridge::ControlNet& first, const bridge::ControlNet& second,
                                          double tolerance, const Context& context);

}  // namespace eliminant::intersect
