// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/bridge/enclosures/ball_curve.hpp>

namespace eliminant::bridge {

// Notation. F = (p, q) with Jacobian J, a box X in C^2 (a product of two complex rectangles) with midpoint m, C an
// approximate inverse of J(m), and the Krawczyk operator K(X) = m - C F(m) + (I - C J(X))(X - m).

/// Proves that X contains exactly one zero of F, and that it is simple: K(X) lies in X and the largest row sum of
/// |I - C J(X)| is below 1. The returned box K(X) encloses that zero. nullopt: nothing was proven.
///
/// Why: for z in X the segment from m to z stays in X, so F(z) - F(m) = M (z - m) with M in the convex set J(X), and
/// z - C F(z) lies in K(X) within X: by Brouwer there is a fixed point, a zero as C is invertible. Two zeros z, z'
/// would satisfy z - z' = (I - C M)(z - z') with a factor below 1 in the maximum norm. The same bound makes C M, and so
/// J, invertible on X. Source: [Krawczyk1969]; for polynomial systems [BreidingRoseTimme2023].
std::optional<PlaneBall> krawczyk_test(const BallCurve& p, const BallCurve& q, const PlaneBall& box,
                                       long precision_bits);

/// One Newton step from the midpoint of `point`, its result rounded to an exact point; nullopt where the Jacobian
/// cannot be inverted at this precision. `step_log2` is an upper bound of log2 of the larger coordinate of the step
/// taken; `noise_log2` one of the radius of its enclosure, which far exceeds the true rounding error at high degrees:
/// rectangles grow when they are multiplied.
struct NewtonStep {
  PlaneBall point;
  long step_log2 = 0;
  long noise_log2 = 0;
};
std::optional<NewtonStep> newton_step(const BallCurve& p, const BallCurve& q, const PlaneBall& point,
                                      long precision_bits);

/// A simple zero: `region` holds it and no other zero, `box` encloses it and lies in the region.
struct SimpleZero {
  PlaneBall region;
  PlaneBall box;
};

/// Encloses the zero near `start` in a box whose radius is at most 2^target_log2: Newton steps, then the Krawczyk test
/// on a slightly larger box, with the precision raised from `first_precision_bits` (that of `start`: with less, a step
/// could lead away from it) up to `max_precision_bits`. nullopt: not reached.
std::optional<SimpleZero> enclose_simple_zero(const BallCurve& p, const BallCurve& q, const PlaneBall& start,
                                              long target_log2, long max_precision_bits,
                                              long first_precision_bits = 96);

/// Encloses the one zero of `region` in a box whose radius is at most 2^target_log2: the box lies in the region, so it
/// holds the same zero. nullopt when max_precision_bits do not suffice.
std::optional<SimpleZero> refine_simple_zero(const BallCurve& p, const BallCurve& q, const PlaneBall& region,
                                             long target_log2, long max_precision_bits);

/// True when `box` and its complex conjugate, taken together, contain one zero only: of real curves, a real one.
bool zero_is_real(const BallCurve& p, const BallCurve& q, const PlaneBall& box);

/// True when the smallest box around both contains one zero only.
bool enclose_same_zero(const BallCurve& p, const BallCurve& q, const PlaneBall& a, const PlaneBall& b);

}  // namespace eliminant::bridge
