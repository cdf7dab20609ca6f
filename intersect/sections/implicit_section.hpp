// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// All of the intersection of a tensor-product surface with F(x, y, z) = 0, F in Q[x, y, z]: the curve
/// F(Phi(u, v)) = 0 in the parameters of the surface by its certified topology, drawn by proven tubes. (s, t) are not a
/// number. Throws InvalidInput when F is constant, LimitReached when `context` says so. docs/surface-intersections.md.
SurfaceResult intersect_surface_with_equation(const symbolic::ParametricSurface& surface,
                                              const symbolic::Polynomial& equation, const Options& options,
                                              const Context& context);

/// The first surface becomes the second one.
void exchange_surfaces(SurfaceResult& result);

}  // namespace eliminant::intersect
