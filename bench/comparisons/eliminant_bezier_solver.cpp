// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include <eliminant/intersect/curve_curve.hpp>
#include <eliminant/intersect/curve_surface.hpp>
#include <support/bezier_problems.hpp>

#include "bezier_solvers.hpp"

namespace eliminant::comparisons {

namespace {

double middle(const intersect::Parameter& parameter) {
  return arf_get_d(arb_midref(parameter->ball.real()), ARF_RND_NEAR);
}

FoundParameters found(const intersect::CurveResult& result) {
  using intersect::Status;
  FoundParameters parameters;
  for (const intersect::CurveSolution& solution : result.solutions) parameters.points.push_back(middle(*solution.t));
  for (const intersect::Overlap& overlap : result.overlap)
    parameters.stretches.push_back({middle((*overlap.t)[0]), middle((*overlap.t)[1])});
  parameters.complete = result.status == Status::certified ||
                        (result.status == Status::infinite && result.rest_status == Status::certified);
  return parameters;
}

}  // namespace

BezierRun eliminant_bezier(const test::BezierCase& bezier) {
  if (bezier.in_plane())
    return [problem = test::curve_curve_problem(bezier)] {
      return found(intersect::intersect_curve_curve(problem, {}, Context()));
    };
  return [problem = test::curve_surface_problem(bezier)] {
    return found(intersect::intersect_curve_surface(problem, {}, Context()));
  };
}

}  // namespace eliminant::comparisons
