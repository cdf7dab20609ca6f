// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>

namespace eliminant::intersect {

/// Somebody's answer: a point, taken as it is written, and its multiplicity where one was said.
struct Candidate {
  symbolic::Rational x_real, x_imaginary, y_real, y_imaginary;
  std::optional<unsigned long> multiplicity;
};

/// How far a candidate is from the nearest solution, in the larger of |x - x'| and |y - y'|.
struct CandidateDistance {
  std::size_t candidate = 0;
  /// Index into the solutions of the report; unset when there is none.
  std::optional<std::size_t> solution;
  /// Proven upper bound; one significant digit or two, rounded up.
  std::string distance;
};

/// What the candidates say of one solution is not its multiplicity: the sum of their multiplicities, 1 for each that
/// names none.
struct MultiplicityError {
  std::size_t solution = 0;
  unsigned long expected = 1;
  unsigned long claimed = 1;
  std::vector<std::size_t> candidates;
};

struct CandidateReport {
  /// The exact answer, against which everything is measured.
  Result truth;
  std::vector<CandidateDistance> matched;
  std::vector<CandidateDistance> spurious;
  /// Candidates on the common component, where there is one.
  std::vector<std::size_t> on_component;
  /// Solutions that no candidate matches.
  std::vector<std::size_t> missing;
  std::vector<MultiplicityError> multiplicity_errors;
  /// Why the candidates are refused; none when they are accepted.
  std::vector<std::string> reasons;
};

/// Compares candidates with the solutions that `options` and the box of the problem list. A candidate matches the
/// nearest solution, each coordinate's distance relative to max(1, its modulus), if that is at most `tolerance`, or its
/// k-th root when the solution has multiplicity k: so far apart may be the answers of an algorithm whose errors are of
/// size `tolerance`. A solution matched once without a multiplicity is no claim about its multiplicity. The candidates
/// are accepted when the exact answer is certified, and nothing is spurious, missing or of wrong multiplicity. Throws
/// as intersect_plane_curves, and InvalidInput unless 0 < tolerance < 1.
CandidateReport match_candidates(const PlaneCurvesProblem& problem, std::span<const Candidate> candidates,
                                 double tolerance, const Options& options, const Context& context);

}  // namespace eliminant::intersect
