// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/prepared_patch.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// All of the intersection of two tensor-product patches on their closed domains: components, singular points, counts
/// and engine of the result; every arc ends on a border or at a singular point.
SurfaceResult intersect_patches(const symbolic::SurfacePiece& first, const symbolic::SurfacePiece& second,
                                const Options& options, const Context& context);

/// The same of two parts of one patch, prepared; `tolerance` is a distance in space. Whether they cover each other is
/// not asked (patch_overlap): that asks in turn whether a patch meets itself.
SurfaceResult intersect_parts_of_patch(PreparedNet first, PreparedNet second, double tolerance, const Context& context);

/// The same of one patch with itself: pairs of different parameters with one point, each curve once.
SurfaceResult intersect_patch_with_itself(const symbolic::SurfacePiece& patch, const Options& options,
                                          const Context& context);

}  // namespace eliminant::intersect
