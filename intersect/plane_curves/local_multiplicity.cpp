// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/plane_curves/local_multiplicity.hpp>

#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/plane_curves/third_equation.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::Polynomial;

bool overlap(const Solution& a, const Solution& b) {
  return acb_overlaps(a.x.ball.get(), b.x.ball.get()) != 0 && acb_overlaps(a.y.ball.get(), b.y.ball.get()) != 0;
}

}  // namespace

std::optional<unsigned long> LocalMultiplicity::at(const PlaneCurvesProblem& problem, const Solution& solution) const {
  const long accuracy =
      std::min(acb_rel_accuracy_bits(solution.x.ball.get()), acb_rel_accuracy_bits(solution.y.ball.get()));
  const long precision_bits = 2 * std::clamp(accuracy, 64L, 1L << 20) + 64;
  if (is_transversal(solution, precision_bits)) return 1;
  for (std::size_t i = 0; i < equations_.size(); ++i) {
    if (!is_smooth(i, solution, precision_bits)) continue;
    std::optional<unsigned long> least;
    for (std::size_t j = 0; j < equations_.size(); ++j) {
      if (j == i) continue;
      const Pair& known = pair(i, j);
      // On a common factor that passes the point the other one vanishes along the whole branch.
      const KeptSolutions on_component =
          solutions_of_third(problem, known.component, {solution}, options_.seed, context_);
      if (!on_component.decided) return std::nullopt;
      if (!on_component.solutions.empty()) continue;
      const auto same = [&](const Solution& other) { return overlap(solution, other); };
      if (std::count_if(known.solutions.begin(), known.solutions.end(), same) != 1) return std::nullopt;
      const auto found = std::find_if(known.solutions.begin(), known.solutions.end(), same);
      if (!least || found->multiplicity < *least) least = found->multiplicity;
    }
    return least;
  }
  return std::nullopt;
}

const LocalMultiplicity::Pair& LocalMultiplicity::pair(std::size_t i, std::size_t j) const {
  const auto [position, added] = pairs_.try_emplace({std::min(i, j), std::max(i, j)});
  if (!added) return position->second;
  PlaneCurvesProblem problem;
  problem.p = equations_[i];
  problem.q = equations_[j];
  const Result result = intersect_plane_curves(problem, options_, context_);
  if (result.status == Status::incomplete) throw LimitReached(*result.limit);
  position->second.component = result.common_component.value_or(Polynomial::constant(2, 1));
  // Without a proof a multiplicity is none.
  if (result.rest_status.value_or(result.status) == Status::certified || !options_.certify)
    position->second.solutions = result.solutions;
  return position->second;
}

/// Whether the derivatives of two equations are independent there.
bool LocalMultiplicity::is_transversal(const Solution& solution, long precision_bits) const {
  std::array<std::array<ComplexBall, 2>, 3> gradients;
  for (std::size_t i = 0; i < equations_.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      gradients[i][k] = evaluate(equations_[i].derivative(k), solution.x.ball, solution.y.ball, precision_bits);
  for (std::size_t i = 0; i < equations_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      ComplexBall determinant;
      acb_mul(determinant.get(), gradients[i][0].get(), gradients[j][1].get(), precision_bits);
      acb_submul(determinant.get(), gradients[i][1].get(), gradients[j][0].get(), precision_bits);
      if (acb_contains_zero(determinant.get()) == 0) return true;
    }
  return false;
}

bool LocalMultiplicity::is_smooth(std::size_t i, const Solution& solution, long precision_bits) const {
  for (std::size_t k = 0; k < 2; ++k) {
    const ComplexBall derivative =
        evaluate(equations_[i].derivative(k), solution.x.ball, solution.y.ball, precision_bits);
    if (acb_contains_zero(derivative.get()) == 0) return true;
  }
  return false;
}

}  // namespace eliminant::intersect
