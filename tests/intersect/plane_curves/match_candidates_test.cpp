// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/plane_curves/match_candidates.hpp>
#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::Rational;

namespace {

/// (0, 0) with multiplicity 2 and (2, 4), (-2, 4), and a pair that is not real.
PlaneCurvesProblem parabola() { return problem("(y-x^2)*(x^2+1)", "y*(y-4)"); }

Candidate real_candidate(const Rational& x, const Rational& y, std::optional<unsigned long> multiplicity = {}) {
  return {x, 0, y, 0, multiplicity};
}

std::vector<Candidate> truth() {
  std::vector<Candidate> candidates{real_candidate(0, 0, 2), real_candidate(2, 4, 1), real_candidate(-2, 4, 1)};
  for (const int y : {0, 4})
    for (const int i : {1, -1}) candidates.push_back({0, i, y, 0, 1});
  return candidates;
}

CandidateReport match(const std::vector<Candidate>& candidates, const Options& options = {}) {
  return match_candidates(parabola(), candidates, 1e-6, options, Context());
}

Rational small(long denominator_power) {
  return Rational(symbolic::Integer(1),
                  symbolic::power(symbolic::Integer(10), static_cast<unsigned long>(denominator_power)));
}

}  // namespace

TEST_CASE("Candidates: the solutions themselves are accepted, in any order") {
  std::vector<Candidate> candidates = truth();
  for (int turn = 0; turn < 3; ++turn) {
    const CandidateReport report = match(candidates);
    CHECK(report.reasons.empty());
    CHECK(report.matched.size() == 7);
    std::rotate(candidates.begin(), candidates.begin() + 2, candidates.end());
  }
}

TEST_CASE("Candidates: perturbed ones are matched with their proven distance, or spurious beyond the tolerance") {
  std::vector<Candidate> candidates = truth();
  candidates[1].x_real = candidates[1].x_real + small(9);
  CandidateReport report = match(candidates);
  CHECK(report.reasons.empty());
  CHECK(report.matched[1].distance.substr(0, 2) == "1.");
  CHECK(report.matched[1].distance.find("e-09") != std::string::npos);
  candidates[1].x_real = candidates[1].x_real + small(3);
  report = match(candidates);
  CHECK(report.reasons.size() == 2);
  REQUIRE(report.spurious.size() == 1);
  CHECK(report.spurious[0].candidate == 1);
  REQUIRE(report.missing.size() == 1);
  CHECK(report.truth.solutions[report.missing[0]].x.real == "2");
  // A double solution is known to the square root only.
  candidates = truth();
  candidates[0].x_real = small(4);
  CHECK(match(candidates).reasons.empty());
  candidates[0].x_real = small(2);
  CHECK(match(candidates).spurious.size() == 1);
}

TEST_CASE("Candidates: dropped, invented, duplicated ones, and wrong multiplicities are reported") {
  std::vector<Candidate> candidates = truth();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    std::vector<Candidate> dropped = candidates;
    dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(i));
    const CandidateReport report = match(dropped);
    CHECK(report.missing.size() == 1);
    CHECK(report.spurious.empty());
    CHECK(report.reasons == std::vector<std::string>{"1 solution is missing"});

    std::vector<Candidate> duplicated = candidates;
    duplicated.push_back(duplicated[i]);
    const CandidateReport twice = match(duplicated);
    REQUIRE(twice.multiplicity_errors.size() == 1);
    CHECK(twice.multiplicity_errors[0].candidates == std::vector<std::size_t>{i, 7});
    CHECK(twice.multiplicity_errors[0].claimed == 2 * twice.multiplicity_errors[0].expected);
    CHECK(twice.reasons.size() == 1);

    std::vector<Candidate> wrong = candidates;
    ++*wrong[i].multiplicity;
    CHECK(match(wrong).multiplicity_errors.size() == 1);
  }
  candidates.push_back(real_candidate(1, 1, 1));
  const CandidateReport report = match(candidates);
  REQUIRE(report.spurious.size() == 1);
  CHECK(report.spurious[0].candidate == 7);
  CHECK(report.missing.empty());
}

TEST_CASE("Candidates: without multiplicities one mention is enough, k mentions say multiplicity k") {
  std::vector<Candidate> candidates = truth();
  for (Candidate& candidate : candidates) candidate.multiplicity.reset();
  CHECK(match(candidates).reasons.empty());
  candidates.push_back(candidates[0]);
  CHECK(match(candidates).reasons.empty());
  candidates.push_back(candidates[0]);
  CHECK(match(candidates).multiplicity_errors.size() == 1);
}

TEST_CASE("Candidates: only what the options list can be missing") {
  Options options;
  options.field = Field::real;
  const std::vector<Candidate> candidates{real_candidate(0, 0), real_candidate(2, 4), real_candidate(-2, 4)};
  CHECK(match(candidates, options).reasons.empty());
  CHECK(match(candidates).missing.size() == 4);
}

TEST_CASE("Candidates: on a common component; no solution at all; a senseless tolerance") {
  const PlaneCurvesProblem shared = problem("(x-y)*(x^2+y^2-1)", "(x-y)*(x-2)");
  Options options;
  options.field = Field::real;
  const std::vector<Candidate> candidates{real_candidate(5, 5), real_candidate(5, 6)};
  const CandidateReport report = match_candidates(shared, candidates, 1e-6, options, Context());
  CHECK(report.on_component == std::vector<std::size_t>{0});
  REQUIRE(report.spurious.size() == 1);
  CHECK(report.spurious[0].candidate == 1);
  CHECK_FALSE(report.spurious[0].solution.has_value());
  CHECK_THROWS_AS(match_candidates(shared, candidates, 0, options, Context()), InvalidInput);
}

TEST_CASE("Candidates: coordinates of very different sizes, beyond the range of double, and fine tolerances") {
  const auto accepted = [](const PlaneCurvesProblem& input, const std::vector<Candidate>& candidates,
                           double tolerance) {
    return match_candidates(input, candidates, tolerance, {}, Context()).reasons.empty();
  };
  const auto power = [](unsigned long exponent) { return Rational(symbolic::power(symbolic::Integer(10), exponent)); };
  // The nearest doubles: the error in x is larger than the difference of the solutions in y.
  const PlaneCurvesProblem wide = problem("x^2-2*10^40", "y^2-2");
  std::vector<Candidate> rounded;
  for (const int sign_x : {1, -1})
    for (const int sign_y : {1, -1})
      rounded.push_back(real_candidate(Rational(sign_x) * Rational(141421356237309510L) * Rational(1000),
                                       Rational(sign_y) * Rational(14142135623730951L) / power(16)));
  CHECK(accepted(wide, rounded, 1e-6));
  const PlaneCurvesProblem distant = problem("x-10^400", "y-1");
  CHECK(accepted(distant, {real_candidate(power(400), 1)}, 1e-6));
  for (const Rational& x : {Rational(-1) * power(800), Rational(2) * power(400), Rational(11) * power(399)})
    CHECK_FALSE(accepted(distant, {real_candidate(x, 1)}, 1e-6));
  CHECK_FALSE(accepted(problem("x-10^308", "y-10^309"), {real_candidate(0, 0)}, 1e-6));
  CHECK_FALSE(accepted(problem("x*(y-1)", "x*(y+x)"), {real_candidate(-1, 1), real_candidate(power(400), 7)}, 1e-6));
  CHECK(accepted(problem("x^2+y^2-5", "x-2*y"), {real_candidate(2, 1), real_candidate(-2, -1)}, 1e-100));
}
