// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// All of the real intersection curve of two tensor-product surfaces over the whole real projective parameter lines:
/// the topology of the eliminant's curve D(u, t) = 0, lifted to both surfaces by the kernel of the Bezoutian matrix.
/// Points of D = 0 that lift to complex parameters or infinite ones only are counted in `counts.excluded`.
SurfaceResult intersect_whole_surfaces(const symbolic::RationalSurface& first, const symbolic::RationalSurface& second,
                                       const Options& options, const Context& context);

/// The same of one surface with itself, each space curve once.
SurfaceResult intersect_whole_surface_with_itself(const symbolic::RationalSurface& surface, const Options& options,
                                                  const Context& context);

}  // namespace eliminant::intersect
