// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <support/curves.hpp>

namespace eliminant::test {

inline intersect::PlaneCurvesProblem problem(std::string_view p, std::string_view q) {
  intersect::PlaneCurvesProblem result;
  result.p = curve(p);
  result.q = curve(q);
  return result;
}

inline intersect::Result solve(const intersect::PlaneCurvesProblem& input, const intersect::Options& options = {}) {
  const Context context;
  return intersect::intersect_plane_curves(input, options, context);
}

inline intersect::Result solve(std::string_view p, std::string_view q, const intersect::Options& options = {}) {
  return solve(problem(p, q), options);
}

/// The audit that every complete answer must pass, whatever the system.
inline bool audit_holds(const intersect::Result& result) {
  unsigned long with_multiplicity = 0;
  unsigned long real = 0;
  for (const auto& solution : result.solutions) {
    with_multiplicity += solution.multiplicity;
    if (solution.reality == intersect::Reality::real) ++real;
  }
  const auto& counts = result.counts;
  return counts.bezout_number == counts.with_multiplicity + counts.at_infinity &&
         counts.with_multiplicity == with_multiplicity && counts.distinct == result.solutions.size() &&
         counts.listed == result.solutions.size() && counts.real == real && counts.undecided == 0;
}

/// One line for each solution: what a determinism test compares.
inline std::string printed(const intersect::Result& result) {
  std::string text;
  for (const auto& s : result.solutions)
    text += s.x.real + " " + s.x.imaginary + " " + s.y.real + " " + s.y.imaginary + " 1e" +
            std::to_string(s.radius_exponent) + " x" + std::to_string(s.multiplicity) + "\n";
  return text;
}

/// Rational points with multiplicities.
using PlantedPoints = std::vector<std::pair<std::pair<Rational, Rational>, unsigned long>>;

/// True when the solutions are exactly these points with these multiplicities.
inline bool are_exactly(const intersect::Result& result, const PlantedPoints& points) {
  if (result.solutions.size() != points.size()) return false;
  return std::all_of(points.begin(), points.end(), [&](const auto& planted) {
    return std::count_if(result.solutions.begin(), result.solutions.end(), [&](const intersect::Solution& s) {
             return acb_contains_fmpq(s.x.ball.get(), planted.first.first.get()) &&
                    acb_contains_fmpq(s.y.ball.get(), planted.first.second.get()) && s.multiplicity == planted.second &&
                    s.reality == intersect::Reality::real;
           }) == 1;
  });
}

}  // namespace eliminant::test
