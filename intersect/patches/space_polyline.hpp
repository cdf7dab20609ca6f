// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// Of `at` from the segment from a to b.
double distance_from_segment(const std::array<double, 3>& a, const std::array<double, 3>& b,
                             const std::array<double, 3>& at);

/// Of `at` from the polyline; infinite where that has fewer than two points.
double distance_in_space(const SurfaceComponent& component, const std::array<double, 3>& at);

}  // namespace eliminant::intersect
