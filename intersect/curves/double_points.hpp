// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/map_pair.hpp>

namespace eliminant::intersect {

/// The pairs of parameters of one map with the same point, unordered: t before u in the order of sort_solutions.
/// Each has its `kind`, and its multiplicity is that of self_intersection.hpp; a point with conjugate parameters is
/// real. `inside` means both parameters. Always all complex pairs, and the counts are theirs; the ends of overlaps
/// that touch are left out. Throws as intersect_map_with_itself.
MapPairResult double_points(const symbolic::CurvePiece& piece, const Options& options, const Context& context);

}  // namespace eliminant::intersect
