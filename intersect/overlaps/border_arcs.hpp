// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/intersect/patches/net_patches.hpp>

namespace eliminant::intersect {

/// An arc of a border curve of one of two patches, in the other patch.
struct BorderArc {
  bridge::ContainedBorder part;
  /// It lies on the border of the other patch, too.
  bool on_both = false;
};

/// What the borders of two patches of one surface have in common with the other patch.
struct BorderArcs {
  /// Each with no point on the border of the other patch but its ends, or all of it there; an arc of both borders once,
  /// as one of the first.
  std::vector<BorderArc> arcs;
  /// Parameters (u, v, s, t) at which two border curves meet; ends of arcs among them.
  std::vector<std::array<double, 4>> meetings;
};

/// Border curves are cut where they meet, by the exact engine for two curves, and one point of each part is looked for
/// in the other patch. nullopt where not everything is certified or two places are nearer than 1e-7.
std::optional<BorderArcs> border_arcs(const PatchNets& first, const PatchNets& second, const Context& context);

}  // namespace eliminant::intersect
