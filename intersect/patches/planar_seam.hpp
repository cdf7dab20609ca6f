// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/nets/zoomed_patches.hpp>

namespace eliminant::intersect {

/// A border that both patches have in common, all of the intersection: one patch has nothing else in the plane of the
/// border, and the other one nothing on its side of that plane. So pieces of surfaces of revolution, mirrored patches
/// and plane caps meet, tips and all. nullopt where that is not proven, by signs of control points and by
/// is_common_border; straight borders lie in no plane of their own.
std::optional<bridge::ContainedBorder> planar_seam(const bridge::PatchPairNets& nets);

}  // namespace eliminant::intersect
