// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/resultant_solver_internal.hpp>

namespace eliminant::numeric {

template ResultantSolution<double> solve_by_resultant(const ResultantProblem<double>&);

}  // namespace eliminant::numeric
