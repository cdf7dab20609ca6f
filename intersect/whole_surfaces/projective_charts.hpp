// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/intersect/patches/parameter_metric.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/intersect/patches/triangle_charts.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// A patch that is a part of a surface, and how its parameters become those of the surface.
struct ProjectiveChart {
  symbolic::SurfacePiece piece;
  /// The parameter of the surface is the inverse of the one of the patch.
  std::array<bool, 2> inverted{};
  /// Of a part of a triangle.
  std::optional<TriangleCorner> corner{};
};

/// Patches that make up the surface: its pieces, triangles cut into three (triangle_charts); without domains parts of
/// the projective parameter lines, half of them by the inverse parameter. `which` is 0 for the first of two surfaces
/// and 1 for the second, whose lines are cut into four at different places, and 2 for a surface of its own, cut at -1
/// and 1.
std::vector<ProjectiveChart> projective_charts(const symbolic::ParametricSurface& surface, std::size_t which);

/// From the parameters of the charts to those of the surfaces.
void to_surface_parameters(SurfaceResult& result, const ProjectiveChart& first, const ProjectiveChart& second);

/// The hull of the domains of all pieces; nothing of a surface without domains.
DomainBounds domain_bounds(const symbolic::ParametricSurface& first, const symbolic::ParametricSurface& second);

}  // namespace eliminant::intersect
