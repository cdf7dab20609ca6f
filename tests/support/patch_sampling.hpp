// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <support/patch_oracle.hpp>

namespace eliminant::test {

/// Over the domain of the first patch as a grid: the height over the second patch, followed along the zeros from cell
/// to cell. The second patch has to project to the (x, y) plane one to one. Nothing is proven: loops inside a cell and
/// pairs of arcs closer than one are not seen.
TrueIntersection sampled_intersection(const PatchCase& patches, std::size_t cells);

/// With ever more cells until the number of arcs agrees with the border points of the exact engine for curves and
/// surfaces. Throws std::logic_error where it never does.
TrueIntersection sampled_intersection(const PatchCase& patches);

/// How many points the four borders of either patch have in common with the other patch, by the exact engine; those in
/// corners and where two borders meet count more than once.
std::size_t border_point_count(const PatchCase& patches);

}  // namespace eliminant::test
