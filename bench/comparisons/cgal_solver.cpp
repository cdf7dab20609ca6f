// SPDX-License-Identifier: BSD-3-Clause
#include <iterator>
#include <utility>
#include <vector>

#include <CGAL/Algebraic_kernel_d_2.h>
#include <CGAL/Gmpz.h>
#include <CGAL/version.h>

#include "solvers.hpp"

namespace eliminant::comparisons {

namespace {

using Kernel = CGAL::Algebraic_kernel_d_2<CGAL::Gmpz>;
using KernelPolynomial = Kernel::Polynomial_2;
using Solution = std::pair<Kernel::Algebraic_real_2, Kernel::Multiplicity_type>;

KernelPolynomial kernel_polynomial(const std::vector<Term>& polynomial) {
  std::vector<std::pair<CGAL::Exponent_vector, CGAL::Gmpz>> terms;
  for (const Term& term : polynomial)
    terms.emplace_back(CGAL::Exponent_vector(static_cast<int>(term.exponent_x), static_cast<int>(term.exponent_y)),
                       CGAL::Gmpz(term.coefficient));
  return CGAL::Polynomial_traits_d<KernelPolynomial>::Construct_polynomial()(terms.begin(), terms.end());
}

}  // namespace

Run cgal_real(const Curves& curves) {
  return [p = kernel_polynomial(curves.p), q = kernel_polynomial(curves.q)] {
    // The kernel keeps what it computed of a curve, so each run has its own.
    const Kernel kernel;
    std::vector<Solution> solutions;
    kernel.solve_2_object()(p, q, std::back_inserter(solutions));
    RunOutcome outcome{static_cast<long>(solutions.size()), true};
    for (const Solution& solution : solutions)
      if (solution.second < 1) outcome.complete = false;
    return outcome;
  };
}

std::string cgal_version() { return "CGAL " CGAL_VERSION_STR; }

}  // namespace eliminant::comparisons
