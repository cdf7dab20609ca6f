// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/resultant_solver_internal.hpp>

namespace eliminant::numeric {

template ResultantSolution<Real1024> solve_by_resultant(const ResultantProblem<Real1024>&);

}  // namespace eliminant::numeric
