// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>

namespace eliminant::intersect {

/// The self-intersections of a rational curve in the plane or in space: every unordered pair of parameters t, u with
/// the same point, and t = u where the derivative of the map vanishes; of a plane curve given by an equation f its
/// singular points f = f_x = f_y = 0, those at infinity included.
///
/// A point with k branches has k (k - 1) / 2 pairs, which `singular_points` gathers. The multiplicity of a pair is the
/// intersection multiplicity of its branches, of a cusp the delta invariant of its branch, so that in the plane the
/// multiplicities over the complex projective line add up to (d - 1) (d - 2) / 2 for a map of degree d that takes
/// general points once: that is `expected`. In space they are those of general projections to a plane; where both
/// branches are singular, or a cusp is of higher order, an upper bound that is not certified.
/// Of an equation the multiplicity is the Milnor number.
///
/// With a domain the real pairs inside it are listed, without one all complex ones; with --real the real points,
/// isolated ones included. Where the pieces of a curve meet there is no self-intersection, nor where a closed curve
/// begins and ends (`closed`). A map that takes general points more than once, pieces that overlap, and a repeated
/// factor of the equation give `infinite`.
/// Throws InvalidInput when a curve is a point or a constant equation, and LimitReached when `context` says so.
CurveResult intersect_curve_with_itself(const SelfIntersectionProblem& problem, const Options& options,
                                        const Context& context);

}  // namespace eliminant::intersect
