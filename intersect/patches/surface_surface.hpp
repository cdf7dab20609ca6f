// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// Two surfaces; at most one given by an equation in x, y, z, whose zeros it is.
struct SurfaceSurfaceProblem {
  std::variant<symbolic::ParametricSurface, symbolic::Polynomial> first;
  std::variant<symbolic::ParametricSurface, symbolic::Polynomial> second;
};

/// All of the real intersection curve: arcs, loops, points of contact, common parts. On bounded domains by subdivision
/// (bridge/branches/branch_subdivision), without domains through the eliminant and its topology.
/// Throws InvalidInput for two equations or a surface that is none, LimitReached when `context` says so.
/// Sources: [BuseElkadiGalligo2008] for the eliminant.
SurfaceResult intersect_surface_surface(const SurfaceSurfaceProblem& problem, const Options& options,
                                        const Context& context);

struct SurfaceSelfIntersectionProblem {
  symbolic::ParametricSurface surface;
};

/// All pairs of different parameters of one surface with one point: double curves, each once, pinch points and triple
/// points. Throws as intersect_surface_surface does.
/// Sources: [BuseElkadiGalligo2008], Theorems 4 and 5.
SurfaceResult intersect_surface_with_itself(const SurfaceSelfIntersectionProblem& problem, const Options& options,
                                            const Context& context);

}  // namespace eliminant::intersect
