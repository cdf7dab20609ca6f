// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>

namespace eliminant::intersect {

/// The value of a polynomial in two variables in a pair of balls.
bridge::ComplexBall evaluate(const symbolic::Polynomial& p, const bridge::ComplexBall& x, const bridge::ComplexBall& y,
                             long precision_bits);

/// Some of the solutions of two equations.
struct KeptSolutions {
  std::vector<Solution> solutions;
  /// Whether a third polynomial vanishes was decided exactly for each; else the balls are too wide for that.
  bool decided = true;
};

/// The solutions of p = q = 0, coprime, at which a third polynomial vanishes too: excluded by its value in the balls,
/// or decided by the gcd of the representation of all solutions with it.
KeptSolutions solutions_of_third(const PlaneCurvesProblem& problem, const symbolic::Polynomial& third,
                                 const std::vector<Solution>& solutions, std::uint64_t seed, const Context& context);

}  // namespace eliminant::intersect
