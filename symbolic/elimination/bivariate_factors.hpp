// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// One factor of p = c * product of factor^multiplicity: primitive over Z, not constant.
struct BivariateFactor {
  Polynomial factor{2};
  unsigned long multiplicity = 1;
  bool irreducible = true;  ///< proven over Q; otherwise only squarefree
};

/// How far to go where a proof of irreducibility by degrees modulo primes fails.
enum class FactorDepth {
  irreducible,  ///< all factors irreducible, however long it takes
  squarefree    ///< factors in one variable irreducible, the others at least squarefree and pairwise coprime
};

/// The factors of a polynomial in two variables that is not zero: those in one variable first. Irreducible polynomials
/// of high degree are recognised by the degrees of their factors modulo a few primes, which needs no factorization
/// over Z. Throws InvalidInput for the zero polynomial or another number of variables, LimitReached.
std::vector<BivariateFactor> bivariate_factors(const Polynomial& p, FactorDepth depth, std::uint64_t seed);

}  // namespace eliminant::symbolic
