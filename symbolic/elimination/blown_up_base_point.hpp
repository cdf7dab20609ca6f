// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// A tensor-product surface with a base point at u = v = 0, in both charts of the blow-up there: in (u, m) with v = u
/// m, and in (m, v) with u = m v, without the powers of u and of v that all coordinates have in common. nullopt where
/// the origin is no base point, or where the weight vanishes on the exceptional line u = 0, or v = 0, for a real m: its
/// terms of least degree have a real zero, or another coordinate has one of lower degree.
std::optional<std::array<RationalSurface, 2>> blown_up_at_origin(const RationalSurface& surface);

}  // namespace eliminant::symbolic
