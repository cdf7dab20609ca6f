// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// Collapsed points: those of a section to which the surface maps whole curves of parameters (the pole of a sphere, the
/// apex of a cone), until `finish_collapsed_points` with u or v not a number and referred to by the curves that end
/// there.
bool has_unknown_parameters(const SurfacePoint& point);

/// Whether points of a section are one: the same place in space and the same (u, v), or both collapsed.
bool is_same_point(const SurfacePoint& a, const SurfacePoint& b);

/// Joins the curves of a section by F(x, y, z) = 0 that end in a collapsed point and go on there: where the
/// intersection of F = 0 with the equation of the surface, of degree 8 at most, is proven to be one smooth arc around
/// it, two ends at the same parameters that are on both sides of it belong together. Where it is proven to be singular,
/// the point is.
void join_at_collapsed_points(SurfaceResult& result, const symbolic::ParametricSurface& surface,
                              const symbolic::Polynomial& equation);

/// Collapsed points become points on their own or singular points, or are left out where curves only end on a border
/// or pass. Two half-branches that are neither joined nor proven to end in a singular point are not certified there.
void finish_collapsed_points(SurfaceResult& result);

}  // namespace eliminant::intersect
