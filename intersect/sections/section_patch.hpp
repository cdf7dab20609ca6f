// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// What a side of the domain of a patch is for the whole surface.
enum class SideRole {
  border,      ///< of the whole surface
  seam,        ///< of two patches; curves along it are found here
  other_seam,  ///< of two patches; curves along it are found on the other one
};

/// For u and v: the lower and the upper side.
using SideRoles = std::array<std::array<SideRole, 2>, 2>;

/// Warnings of results in which more is doubtful than how curves are drawn.
inline constexpr const char* topology_not_proven = "the topology of the curve in the parameters is not proven";
inline constexpr const char* beyond_doubles = "coordinates are beyond the range in which hardware doubles are safe";

/// The intersection of one patch with a surface F(x, y, z) = 0, (s, t) unknown. Points of singular_points with an
/// unknown u or v are those to which a whole curve of parameters is mapped; arcs that end there refer to them.
SurfaceResult intersect_patch_with_equation(const symbolic::SurfacePiece& patch, const symbolic::Polynomial& equation,
                                            const SideRoles& roles, const Options& options, const Context& context);

}  // namespace eliminant::intersect
