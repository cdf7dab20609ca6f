// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// A patch as the engine of patches takes it, weights positive where they have one sign. Throws InvalidInput where it
/// is none; `which` names the surface.
PreparedNet prepared_patch(const symbolic::SurfacePiece& piece, const char* which);

bool has_positive_weights(const PreparedNet& net);

/// Largest side of the box around the control points.
double size_of(const PreparedNet& net);

/// Changes the parameter of an axis, exactly, so that the weights of a patch with positive ones do not rise or fall
/// along it: u / (1 - u) is the number returned, a power of two, times that of the new parameter.
double balance_weights(PreparedNet& net, std::size_t axis);

}  // namespace eliminant::intersect
