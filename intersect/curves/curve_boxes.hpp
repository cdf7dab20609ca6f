// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// The box engine for two plane curves: all solutions (t, u) within both closed domains, proven and none missing;
/// nullopt where it cannot decide: no bounded domains, a contact at irrational parameters, a cusp on the other curve, a
/// common part, an irrational point at the end of one curve.
std::optional<std::vector<CurveSolution>> solve_by_boxes(const symbolic::CurvePiece& first,
                                                         const symbolic::CurvePiece& second, const Options& options,
                                                         const Context& context);

}  // namespace eliminant::intersect
