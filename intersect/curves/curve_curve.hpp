// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>

namespace eliminant::intersect {

/// All intersections of two curves, both in the plane or both in space: each pair of parameters (t, u) of one common
/// point is a solution, with the intersection multiplicity of the two branches. With domains only the real ones inside
/// them are listed, unless options.field says complex.
/// Throws InvalidInput when one curve is plane and the other not, or an option is out of range, and LimitReached.
CurveResult intersect_curve_curve(const CurveCurveProblem& problem, const Options& options, const Context& context);

}  // namespace eliminant::intersect
