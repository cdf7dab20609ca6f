// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::bridge {

/// The common points of two polynomial curves of which one has a coordinate that is linear in its parameter, as borders
/// of graphs have: that parameter is a polynomial in the other one, and the greatest common divisor of the other
/// coordinates' differences has the points as its roots.
///
/// Returns the parameters (t, u) in [0, 1] x [0, 1] of all of them, in ascending order of t or of u, rounded to
/// doubles; whether a point is within the domains is decided exactly. nullopt where there is no such coordinate, where
/// the curves have infinitely many points in common, or where a root is too close to the end of a domain.
std::optional<std::vector<std::array<double, 2>>> meetings_by_substitution(const symbolic::RationalCurve& first,
                                                                           const symbolic::RationalCurve& second,
                                                                           const Context& context);

}  // namespace eliminant::bridge
