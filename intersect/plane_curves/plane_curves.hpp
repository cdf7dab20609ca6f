// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::intersect {

/// A closed rectangle [lower_x, upper_x] x [lower_y, upper_y] of the real plane.
struct Box {
  std::array<symbolic::Rational, 2> x;
  std::array<symbolic::Rational, 2> y;
};

/// Two plane curves p = 0 and q = 0 with p, q in Q[x, y] (two variables; any polynomials, also zero or constant).
struct PlaneCurvesProblem {
  symbolic::Polynomial p{2};
  symbolic::Polynomial q{2};
  std::vector<std::string> variables{"x", "y"};
  std::optional<Box> box;
};

/// All common zeros of p and q, with intersection multiplicities; see Result for what is guaranteed.
/// A common component is split off exactly and reported, the cofactors are solved. With a box only the real solutions
/// inside it are listed; whether one lies on the border is decided exactly.
/// Throws InvalidInput when the polynomials do not have two variables, an option is out of range, or the box is empty,
/// and LimitReached when `context` says so.
/// Source: [BuseKhalilMourrain2005], Algorithms 1 and 2; docs/plane-curves.md.
Result intersect_plane_curves(const PlaneCurvesProblem& problem, const Options& options, const Context& context);

}  // namespace eliminant::intersect
