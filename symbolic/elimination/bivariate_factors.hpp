// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// One factor of p = c * product of factor^multiplicity: irreducible over Q, primitive over Z, not constant.
struct BivariateFactor {
  Polynomial factor{2};
  unsigned long multiplicity = 1;
};

/// The factors of a polynomial in two variables that is not zero, those in one variable first. Irreducible polynomials
/// of high degree are recognised by the degrees of their factors modulo a few primes on lines, which is a proof and
/// needs no factorization over Z. Throws InvalidInput for the zero polynomial or another number of variables,
/// LimitReached.
std::vector<BivariateFactor> bivariate_factors(const Polynomial& p, std::uint64_t seed);

}  // namespace eliminant::symbolic
