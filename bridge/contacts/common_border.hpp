// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <eliminant/bridge/nets/zoomed_patches.hpp>

namespace eliminant::bridge {

/// Whether all of a border curve (axis 0 to 3, side -1 or 1) of one of two patches on [0, 1]^2 lies on a border curve
/// of the other, with parameters that are a quotient of low degree with simple rational coefficients of one another, as
/// those of proper rational parametrisations of one curve are, by projective maps. A proof where true: the parameters
/// are recognised (contact_relation_fit) and the maps equal along the border, exactly (symbolic::meet_along).
bool is_common_border(const PatchPairNets& nets, std::size_t axis, int side);

}  // namespace eliminant::bridge
