// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::symbolic {

/// One factor of p = c * product of factor^multiplicity: primitive, squarefree, of positive degree.
struct SquarefreeFactor {
  UnivariatePolynomial factor;
  unsigned long multiplicity = 1;
};

/// The squarefree decomposition of a non-zero p over Z, by increasing multiplicity; the factors are pairwise coprime.
/// Throws InvalidInput for the zero polynomial.
std::vector<SquarefreeFactor> squarefree_decomposition(const UnivariatePolynomial& p);

}  // namespace eliminant::symbolic
