// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/branches/patch_border_points.hpp>
#include <eliminant/intersect/patches/balanced_pair.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// Of a border that is one point (axis 0 to 3, side -1 or 1): all of it, where doubles cannot tell the point from one
/// of the other patch, which is no proof; else nothing.
bridge::ContainedParts contained_point(const BalancedPair& pair, std::size_t axis, int side);

/// Where a border is one point, which seems to lie in the other patch: curves that come near to it are drawn to it, and
/// if there is none it is a point of the intersection; neither is certified.
void end_at_point(std::vector<SurfaceComponent>& components, const BalancedPair& pair,
                  const bridge::ContainedBorder& border);

}  // namespace eliminant::intersect
