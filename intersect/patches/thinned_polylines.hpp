// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// Points of all polylines of a result together, at most: about 100 MB of JSON.
inline constexpr std::size_t most_points = 500000;

/// Leaves out every second point of the longest polylines, again and again, until there are at most `most` points, or
/// all polylines are short. The ends remain. The distance in space of what is left out is added to `error`, which
/// remains a bound; a warning says so.
void thin_polylines(SurfaceResult& result, std::size_t most = most_points);

}  // namespace eliminant::intersect
