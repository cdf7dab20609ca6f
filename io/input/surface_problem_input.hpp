// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <variant>

#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>
#include <eliminant/io/results/json_fields.hpp>

namespace eliminant::io {

/// The surfaces of "first" and "second", at most one of them given by an equation. Throws as read_surface does, and
/// InvalidInput with the place of the second one where both are equations.
intersect::SurfaceSurfaceProblem read_surface_pair(const JsonFields& fields, const JsonValue& first,
                                                   const JsonValue& second);

/// What meets itself: the "curve" or the "surface" of `object`, a surface with parameters. Throws InvalidInput where
/// none or both are there.
std::variant<intersect::SelfIntersectionProblem, intersect::SurfaceSelfIntersectionProblem> read_self_intersection(
    const JsonFields& fields, const JsonValue& object);

}  // namespace eliminant::io
