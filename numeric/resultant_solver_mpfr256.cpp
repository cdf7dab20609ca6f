// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/resultant_solver_internal.hpp>

namespace eliminant::numeric {

template ResultantSolution<Real256> solve_by_resultant(const ResultantProblem<Real256>&);

}  // namespace eliminant::numeric
