// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/enclosures/ball_curve.hpp>
#include <eliminant/intersect/plane_curves/match_candidates.hpp>

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

/// The distance of a candidate from a solution: of the larger coordinate difference, and of the same relative to
/// max(1, |coordinate|) of each.
struct Distance {
  RealBall absolute;
  RealBall relative;
};

Distance distance(const PlaneBall& a, const Solution& b, long precision_bits) {
  Distance result;
  for (const auto& [found, truth] : {std::pair{&a.x, &b.x.ball}, {&a.y, &b.y.ball}}) {
    ComplexBall difference;
    RealBall length;
    RealBall size;
    RealBall one;
    acb_sub(difference.get(), found->get(), truth->get(), precision_bits);
    acb_abs(length.get(), difference.get(), precision_bits);
    arb_max(result.absolute.get(), result.absolute.get(), length.get(), precision_bits);
    acb_abs(size.get(), truth->get(), precision_bits);
    arb_one(one.get());
    arb_max(size.get(), size.get(), one.get(), precision_bits);
    arb_div(length.get(), length.get(), size.get(), precision_bits);
    arb_max(result.relative.get(), result.relative.get(), length.get(), precision_bits);
  }
  return result;
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

/// Whether the relative distance is at most the k-th root of the tolerance, k the multiplicity: decided of the ball's
/// midpoint, whose error is far below the tolerance.
bool within_reach(const Distance& found, unsigned long multiplicity, double tolerance) {
  RealBall power;
  constexpr long precision_bits = 128;
  arb_pow_ui(power.get(), found.relative.get(), multiplicity, precision_bits);
  RealBall limit;
  arb_set_d(limit.get(), tolerance);
  return arf_cmp(arb_midref(power.get()), arb_midref(limit.get())) <= 0;
}

/// To first order, the distance from the component is its value over its slope.
bool near_component(const symbolic::Polynomial& component, const PlaneBall& point, double tolerance,
                    long precision_bits) {
  if (component.is_zero()) return true;
  const bridge::BallJet jet = bridge::BallCurve(component).jet(point, precision_bits);
  const auto modulus = [&](const ComplexBall& z) {
    RealBall result;
    acb_abs(result.get(), z.get(), precision_bits);
    return result;
  };
  RealBall slope;
  arb_add(slope.get(), modulus(jet.dx).get(), modulus(jet.dy).get(), precision_bits);
  RealBall scale;
  arb_one(scale.get());
  arb_max(scale.get(), scale.get(), modulus(point.x).get(), precision_bits);
  arb_max(scale.get(), scale.get(), modulus(point.y).get(), precision_bits);
  RealBall limit;
  arb_set_d(limit.get(), tolerance);
  arb_mul(limit.get(), limit.get(), slope.get(), precision_bits);
  arb_mul(limit.get(), limit.get(), scale.get(), precision_bits);
  return arf_cmp(arb_midref(modulus(jet.value).get()), arb_midref(limit.get())) <= 0;
}

std::string plural(std::size_t count, const std::string& one, const std::string& several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

}  // namespace

CandidateReport match_candidates(const PlaneCurvesProblem& problem, std::span<const Candidate> candidates,
                                 double tolerance, const Options& options, const Context& context) {
  if (!(tolerance > 0 && tolerance < 1))
    throw InvalidInput("the tolerance is not between 0 and 1", "a number between 0 and 1");
  // As many digits of the truth as the tolerance and the sizes of the candidates ask for.
  Options accurate = options;
  const auto tolerance_digits = static_cast<long>(std::ceil(-std::log10(tolerance)));
  accurate.digits = std::max(options.digits, tolerance_digits + 5);
  CandidateReport report;
  report.truth = intersect_plane_curves(problem, accurate, context);
  const std::vector<Solution>& solutions = report.truth.solutions;
  long size_bits = 0;
  for (const Candidate& candidate : candidates)
    for (const auto* part : {&candidate.x_real, &candidate.x_imaginary, &candidate.y_real, &candidate.y_imaginary})
      size_bits = std::max(size_bits, static_cast<long>(part->numerator().bit_length()) -
                                          static_cast<long>(part->denominator().bit_length()));
  for (const Solution& solution : solutions)
    for (const ComplexBall* z : {&solution.x.ball, &solution.y.ball})
      for (const arb_srcptr part : {z->real(), z->imaginary()})
        size_bits = std::max(size_bits, static_cast<long>(arf_abs_bound_lt_2exp_si(arb_midref(part))));
  const long precision_bits = 4 * accurate.digits + 2 * size_bits + 128;
  std::vector<std::vector<std::size_t>> matches(solutions.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    context.checkpoint("comparing candidates");
    const PlaneBall point = ball_of(candidates[i], precision_bits);
    CandidateDistance found{i, std::nullopt, {}};
    Distance smallest;
    for (std::size_t k = 0; k < solutions.size(); ++k) {
      Distance current = distance(point, solutions[k], precision_bits);
      if (found.solution && arf_cmp(arb_midref(current.relative.get()), arb_midref(smallest.relative.get())) >= 0)
        continue;
      found.solution = k;
      smallest = std::move(current);
    }
    if (found.solution) found.distance = printed_bound(smallest.absolute);
    if (found.solution && within_reach(smallest, solutions[*found.solution].multiplicity, tolerance)) {
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
