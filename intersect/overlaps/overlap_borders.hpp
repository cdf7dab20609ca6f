// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/intersect/patches/parameter_metric.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// Takes out curves and points that lie on the outline of an overlap: of surfaces of several pieces the border of an
/// overlap of two pieces is a curve that one of these has in common with the next piece of the other.
void remove_borders_of_overlaps(SurfaceResult& result, const DomainBounds& bounds);

}  // namespace eliminant::intersect
