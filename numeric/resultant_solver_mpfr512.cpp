// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/resultant_solver_internal.hpp>

namespace eliminant::numeric {

template ResultantSolution<Real512> solve_by_resultant(const ResultantProblem<Real512>&);

}  // namespace eliminant::numeric
