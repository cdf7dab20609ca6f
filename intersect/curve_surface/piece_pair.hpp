// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curve_surface/prepared_surface.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// One piece of a curve with one piece of a surface, by the first of the engines asked for that decides it: boxes,
/// pencil, exact elimination. Adds the solutions, overlaps, counts and warnings to the result and lowers its status.
/// Throws LimitReached when the base points of the surface leave no matrix representation.
void intersect_pieces(const symbolic::CurvePiece& curve, PreparedSurface& surface, const Options& options,
                      const Context& context, CurveResult& result);

}  // namespace eliminant::intersect
