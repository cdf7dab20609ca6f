// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// True when the image of the map is a surface, false when it is only a curve or a point: whether the 4 x 3 matrix over
/// Q[parameters] of the coordinates and their two derivatives (or of the three derivatives of forms) has rank 3.
/// Exact: rank 3 at one rational point proves it, minors that vanish identically refute it.
bool is_two_dimensional(const RationalSurface& surface);

}  // namespace eliminant::symbolic
