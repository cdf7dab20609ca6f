// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/intersect/patches/parameter_metric.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// Lists singular points that several pieces of a surface have found, each on its side of a seam, once: contacts and
/// crossings at the same parameters, and undecided ones whose boxes touch. A contact in which a curve ends on another
/// piece is a crossing; half-branches of crossings are counted again.
void join_singular_points(SurfaceResult& result, const DomainBounds& bounds);

}  // namespace eliminant::intersect
