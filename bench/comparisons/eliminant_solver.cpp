// SPDX-License-Identifier: BSD-3-Clause
#include <utility>
#include <vector>

#include <eliminant/intersect/plane_curves/plane_curves.hpp>

#include "solvers.hpp"

namespace eliminant::comparisons {

namespace {

symbolic::Polynomial exact_polynomial(const std::vector<Term>& polynomial) {
  std::vector<symbolic::Polynomial::Term> terms;
  terms.reserve(polynomial.size());
  for (const Term& term : polynomial)
    terms.push_back({symbolic::Integer::from_string(term.coefficient), {term.exponent_x, term.exponent_y}});
  return symbolic::Polynomial::from_terms(2, terms);
}

Run intersection(const Curves& curves, intersect::Field field) {
  intersect::PlaneCurvesProblem problem;
  problem.p = exact_polynomial(curves.p);
  problem.q = exact_polynomial(curves.q);
  intersect::Options options;
  options.field = field;
  return [problem = std::move(problem), options] {
    const intersect::Result result = intersect::intersect_plane_curves(problem, options, Context());
    return RunOutcome{static_cast<long>(result.solutions.size()), result.status == intersect::Status::certified};
  };
}

}  // namespace

Run eliminant_complex(const Curves& curves) { return intersection(curves, intersect::Field::complex); }

Run eliminant_real(const Curves& curves) { return intersection(curves, intersect::Field::real); }

}  // namespace eliminant::comparisons
