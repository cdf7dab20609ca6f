// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/intersect/sections/section_patch.hpp>
#include <eliminant/intersect/whole_surfaces/projective_charts.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// A part of a surface on which it is cut by an equation.
struct SectionChart {
  ProjectiveChart chart;
  /// One of both around a base point that is blown up: the parameter of the chart that is kept, while the other one is
  /// the quotient of the other parameter by it (symbolic/elimination/blown_up_base_point).
  std::optional<std::size_t> kept{};
  SideRoles roles{};
};

/// All of the surface: its projective charts, those at both infinite parameters blown up where that leaves no base
/// point.
std::vector<SectionChart> section_charts(const symbolic::ParametricSurface& surface);

/// From the parameters of the chart to those of the surface.
void to_surface_parameters(SurfaceResult& result, const SectionChart& chart);

}  // namespace eliminant::intersect
