// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// Points of a patch with three preimages in its domain: where the double curves that were traced cross in the plane of
/// parameters one preimage belongs to two pairs. Each is proven: by Krawczyk's test in the six parameters with
/// Phi(p) = Phi(q) = Phi(r), on disjoint boxes. Those at which two of the sheets are tangent are not found.
std::vector<SurfaceSingularPoint> triple_points(const symbolic::SurfacePiece& patch,
                                                const std::vector<SurfaceComponent>& double_curves,
                                                const Context& context);

}  // namespace eliminant::intersect
