// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// Two tensor-product patches with positive weights that have one corner in common, and no other point: for u, v, s, t
/// whether that is where the parameter is 0 (-1) or 1. Proven by a plane through the corner that has all other control
/// points of the first patch on one side and those of the second on the other side or on the plane; nullopt where a
/// few likely planes do not, or where more corners are common.
std::optional<std::array<int, 4>> only_common_corner(const ExactNet& first, const ExactNet& second);

}  // namespace eliminant::bridge
