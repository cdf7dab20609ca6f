// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/nets/zoomed_patches.hpp>
#include <eliminant/intersect/patches/contact_arcs.hpp>

namespace eliminant::intersect {

/// All of the intersection of two patches on [0, 1]^2, each arc smooth between its ends.
struct PatchSection {
  std::vector<ContactArc> arcs;
  /// Both patches touch along the arcs.
  bool tangential = false;

  /// A border of a patch that is one point, on its own in the intersection.
  struct Point {
    /// u, v, s, t; that along the border is not a number.
    std::array<double, 4> parameters{};
    std::array<int, 4> side{};
  };
  std::vector<Point> points;
};

/// The curve F(Phi(u, v)) = 0 on one patch Phi, in the domain of the other one, of which F = 0 is the equation, where
/// that has rational inverses at all of its points (symbolic/elimination/rational_inversion): planes, cylinders.
/// Borders of Phi that are one point, as poles and apices are no obstacle: they are factors of the function on their
/// own. nullopt where there is no such patch, for curves with singular points, and where anything is not proven.
std::optional<PatchSection> patch_section(const bridge::PatchPairNets& nets, double tolerance, double size,
                                          const Context& context);

}  // namespace eliminant::intersect
