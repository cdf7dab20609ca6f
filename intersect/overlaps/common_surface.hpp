// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/intersect/overlaps/patch_overlap.hpp>

namespace eliminant::intersect {

/// What two patches on [0, 1]^2 of one algebraic surface S of low degree have in common, by the arcs of each border
/// that lie in the other patch. Complete: both patches are proven to be embedded and S to be smooth on the first, so
/// that each is a disc in S, and what they have in common is bounded by their borders. Which arcs of these lie in the
/// other patch, or on its border, is decided by the exact engines. nullopt when any of this fails: another surface,
/// higher degree, a patch that meets itself, a common part that is no disc or touches itself.
std::optional<PatchOverlap> parts_of_common_surface(const PatchNets& first, const PatchNets& second, double tolerance,
                                                    const Context& context);

}  // namespace eliminant::intersect
