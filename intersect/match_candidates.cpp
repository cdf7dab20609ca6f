// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/ball_curve.hpp>
#include <eliminant/intersect/match_candidates.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using bridge::PlaneBall;
using bridge::RealBall;

PlaneBall ball_of(const Candidate& candidate, long precision_bits) {
  PlaneBall point;
  arb_set_fmpq(point.x.real(), candidate.x_real.get(), precision_bits);
  arb_set_fmpq(point.x.imaginary(), candidate.x_imaginary.get(), precision_bits);
  arb_set_fmpq(point.y.real(), candidate.y_real.get(), precision_bits);
  arb_set_fmpq(point.y.imaginary(), candidate.y_imaginary.get(), precision_bits);
  return point;
}

/// max(|x - x'|, |y - y'|) as a ball.
RealBall distance(const PlaneBall& a, const Solution& b, long precision_bits) {
  RealBall result;
  RealBall other;
  ComplexBall difference;
  acb_sub(difference.get(), a.x.get(), b.x.ball.get(), precision_bits);
  acb_abs(result.get(), difference.get(), precision_bits);
  acb_sub(difference.get(), a.y.get(), b.y.ball.get(), precision_bits);
  acb_abs(other.get(), difference.get(), precision_bits);
  arb_max(result.get(), result.get(), other.get(), precision_bits);
  return result;
}

double upper_bound(const RealBall& value) {
  RealBall bound;
  arb_get_ubound_arf(arb_midref(bound.get()), value.get(), 53);
  return arf_get_d(arb_midref(bound.get()), ARF_RND_UP);
}

/// Two significant digits, rounded up; beyond the range of double by its power of ten.
std::string printed_bound(const RealBall& value) {
  if (arb_is_zero(value.get()) != 0) return "0";
  RealBall bound;
  arb_get_ubound_arf(arb_midref(bound.get()), value.get(), 53);
  const double approximate = arf_get_d(arb_midref(bound.get()), ARF_RND_UP);
  if (approximate > 1e-300 && approximate < 1e300) {
    // Printing rounds to nearest: a twentieth of the last digit printed makes it up.
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.1e", approximate * 1.05);
    return text.data();
  }
  const long log2 = static_cast<long>(fmpz_get_si(ARF_EXPREF(arb_midref(bound.get()))));
  return "1e" + std::to_string(static_cast<long>(std::ceil(static_cast<double>(log2) * 0.30103)));
}

double modulus(const ComplexBall& z) {
  return std::hypot(arf_get_d(arb_midref(z.real()), ARF_RND_NEAR), arf_get_d(arb_midref(z.imaginary()), ARF_RND_NEAR));
}

/// The reach within which a candidate matches this solution.
double reach(const Solution& solution, double tolerance) {
  return std::max({1.0, modulus(solution.x.ball), modulus(solution.y.ball)}) *
         std::pow(tolerance, 1.0 / static_cast<double>(solution.multiplicity));
}

/// To first order, the distance from the component is its value over its slope.
bool near_component(const symbolic::Polynomial& component, const PlaneBall& point, double tolerance,
                    long precision_bits) {
  if (component.is_zero()) return true;
  const bridge::BallJet jet = bridge::BallCurve(component).jet(point, precision_bits);
  const double scale = std::max({1.0, modulus(point.x), modulus(point.y)});
  return modulus(jet.value) <= tolerance * scale * (modulus(jet.dx) + modulus(jet.dy));
}

std::string plural(std::size_t count, const std::string& one, const std::string& several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

}  // namespace

CandidateReport match_candidates(const PlaneCurvesProblem& problem, std::span<const Candidate> candidates,
                                 double tolerance, const Options& options, const Context& context) {
  if (!(tolerance > 0 && tolerance < 1))
    throw InvalidInput("the tolerance is not between 0 and 1", "a number between 0 and 1");
  const long precision_bits = 4 * options.digits + 128;
  CandidateReport report;
  report.truth = intersect_plane_curves(problem, options, context);
  const std::vector<Solution>& solutions = report.truth.solutions;
  std::vector<std::vector<std::size_t>> matches(solutions.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    context.checkpoint("comparing candidates");
    const PlaneBall point = ball_of(candidates[i], precision_bits);
    CandidateDistance found{i, std::nullopt, {}};
    RealBall smallest;
    for (std::size_t k = 0; k < solutions.size(); ++k) {
      RealBall current = distance(point, solutions[k], precision_bits);
      if (found.solution && arf_cmp(arb_midref(current.get()), arb_midref(smallest.get())) >= 0) continue;
      found.solution = k;
      smallest = std::move(current);
    }
    if (found.solution) found.distance = printed_bound(smallest);
    if (found.solution && upper_bound(smallest) <= reach(solutions[*found.solution], tolerance)) {
      matches[*found.solution].push_back(i);
      report.matched.push_back(std::move(found));
    } else if (report.truth.common_component &&
               near_component(*report.truth.common_component, point, tolerance, precision_bits)) {
      report.on_component.push_back(i);
    } else {
      report.spurious.push_back(std::move(found));
    }
  }
  for (std::size_t k = 0; k < solutions.size(); ++k) {
    if (matches[k].empty()) {
      report.missing.push_back(k);
      continue;
    }
    MultiplicityError claim{k, solutions[k].multiplicity, 0, matches[k]};
    bool said = matches[k].size() > 1;
    for (const std::size_t i : matches[k]) {
      claim.claimed += candidates[i].multiplicity.value_or(1);
      said = said || candidates[i].multiplicity.has_value();
    }
    if (said && claim.claimed != claim.expected) report.multiplicity_errors.push_back(std::move(claim));
  }
  const Status status = report.truth.rest_status.value_or(report.truth.status);
  if (status != Status::certified) report.reasons.emplace_back("the exact answer could not be proven complete");
  if (!report.spurious.empty())
    report.reasons.push_back(plural(report.spurious.size(), "candidate is", "candidates are") + " no solution");
  if (!report.missing.empty())
    report.reasons.push_back(plural(report.missing.size(), "solution is", "solutions are") + " missing");
  if (!report.multiplicity_errors.empty())
    report.reasons.push_back(plural(report.multiplicity_errors.size(), "solution has", "solutions have") +
                             " another multiplicity");
  return report;
}

}  // namespace eliminant::intersect
