// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// Adds the components, singular points and warnings of a pair of pieces to those before; the worse of both statuses.
void append(SurfaceResult& all, SurfaceResult part);

/// Sorts the components, sets the counts, and lowers the status to `numeric` where something is not certified.
void summarise(SurfaceResult& result);

}  // namespace eliminant::intersect
