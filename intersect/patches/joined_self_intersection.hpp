// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// All of the double points of a bounded surface of several pieces, of a triangle, or of a patch whose weights have
/// both signs: as intersect_patch_with_itself, but for pinch points, at which it stays numeric, and triple points,
/// which are not listed. Where pieces meet, and where a surface closes, there are no double points. Throws InvalidInput
/// where a piece does not depend on both parameters.
SurfaceResult intersect_joined_surface_with_itself(const symbolic::ParametricSurface& surface, const Options& options,
                                                   const Context& context);

}  // namespace eliminant::intersect
