// SPDX-License-Identifier: BSD-3-Clause
//
// A user's program: meets the circle x^2 + y^2 = 5 with the hyperbola x y = 2, in (1,2), (2,1), (-1,-2), (-2,-1).
#include <eliminant/eliminant.hpp>
#include <iostream>

int main() {
  using eliminant::symbolic::Polynomial;
  using eliminant::symbolic::Rational;

  const Polynomial x = Polynomial::variable(2, 0);
  const Polynomial y = Polynomial::variable(2, 1);
  eliminant::intersect::PlaneCurvesProblem problem;
  problem.p = x * x + y * y - Polynomial::constant(2, Rational(5));
  problem.q = x * y - Polynomial::constant(2, Rational(2));

  const eliminant::Context context;
  const auto result = eliminant::intersect::intersect_plane_curves(problem, {}, context);
  std::cout << "eliminant " << eliminant::version << '\n';
  for (const auto& solution : result.solutions) std::cout << solution.x.real << ' ' << solution.y.real << '\n';
  return result.counts.distinct == 4 && result.counts.real == 4 && result.solutions.size() == 4 ? 0 : 1;
}
