// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>

namespace eliminant::intersect {

/// All intersections of a rational space curve with a surface, with the parameters on both and intersection
/// multiplicities. With domains only the real ones inside them are listed, unless options.field says complex.
/// Throws InvalidInput when the curve is no space curve or an option is out of range, and LimitReached.
/// Source: [LuuBuseMourrain2009].
CurveResult intersect_curve_surface(const CurveSurfaceProblem& problem, const Options& options, const Context& context);

}  // namespace eliminant::intersect
