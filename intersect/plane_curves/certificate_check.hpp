// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/plane_curves/certificate.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>

namespace eliminant::intersect {

/// Checks a certificate against the curves of a problem, p = q = 0, trusting nothing in it; a box is not looked at: the
/// returned reasons are why it proves nothing, and none means that every ball holds exactly one solution of the
/// multiplicity said, that the balls are pairwise disjoint, and that there are no other solutions in C^2. The routine
/// shares nothing with the engines but polynomial and ball arithmetic:
///
/// 1. A common component divides both; what is left is coprime, because the count below comes out finite.
/// 2. A simple solution: the interval Newton operator m - J(B)^-1 F(m) maps the box B around its ball into the ball.
/// 3. The count without shears: the leading forms are coprime over Q, so Bezout's number counts the solutions; as many
///    disjoint simple ones are all.
/// 4. The count with shears: the eliminant C_s(t) = Res_y(p(t - s y, y), q(t - s y, y)) is computed over Z by
///    evaluation and interpolation, for an s at which neither leading form vanishes; its degree is the number of
///    solutions with multiplicity, and the multiplicity of a root the sum of those of the solutions above it.
/// 5. With two shears: discs of radius n |R / R'| around x + s y, R the squarefree factor of the multiplicity said,
///    isolate all roots of both eliminants. A solution above a disc of the first and one of the second lies in the box
///    of both. For a ball of multiplicity above 1 the boxes of its first disc with all second discs but its own hold no
///    solution (p or q is not zero there), so its own box, which lies in the ball, holds one solution with all of
///    the multiplicity. Above the disc of a simple ball there is one solution only, and its box of step 2 holds it.
///
/// Reality: a ball with real centre is its own mirror image, and so is its one solution. Throws LimitReached when
/// `context` says so.
std::vector<std::string> check_certificate(const PlaneCurvesProblem& problem, const Certificate& certificate,
                                           const Context& context);

}  // namespace eliminant::intersect
