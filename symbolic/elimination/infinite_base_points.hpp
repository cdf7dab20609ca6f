// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// Whether all points of a tensor-product surface go to infinity as both parameters go to 0, along whatever path on
/// which the weight is not zero. False decides nothing. For base points there: of planes, graphs and other polynomial
/// maps, in the inverses of their parameters.
/// Method: a linear form of the point is the inverse of a parameter; or in the inverses the map is polynomial and the
/// forms of highest degree of the coordinates have no real zero in common but 0.
bool is_infinite_around_origin(const RationalSurface& surface);

}  // namespace eliminant::symbolic
