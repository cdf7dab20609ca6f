// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/intersect/patches/parameter_metric.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// Of u, v, s, t, and the third barycentric coordinates of triangles in place of (u, v) and (s, t).
using KeptParameters = std::array<bool, 6>;
inline constexpr std::size_t first_third_coordinate = 4;

/// The parameters that keep their value along the whole curve: it lies on a border or a seam there.
KeptParameters kept_parameters(const SurfaceComponent& component);

/// How far in the parameters a polyline passes from a point.
double distance_to(const SurfaceComponent& component, const std::array<double, 4>& at, const ParameterMetric& metric);

/// A curve along a seam is found on both sides of it: one is enough, that which is cut where branches of its side end
/// in it.
void remove_repeated_seams(std::vector<SurfaceComponent>& components, const ParameterMetric& metric);

}  // namespace eliminant::intersect
