// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// All of the intersection of two surfaces without domains where one of them, S with F = 0, has rational inverses
/// (symbolic/elimination/rational_inversion): the curve F(Phi(u, v)) = 0 on the other one, lifted by them. Certified,
/// or numeric where only ends and the distances of polylines are not proven; nullopt where neither surface has
/// inverses, a common point may have no parameters on S, the surfaces are one, or the topology of the section is not
/// certified. Throws LimitReached.
std::optional<SurfaceResult> intersect_by_inversion(const symbolic::RationalSurface& first,
                                                    const symbolic::RationalSurface& second, const Options& options,
                                                    const Context& context);

}  // namespace eliminant::intersect
