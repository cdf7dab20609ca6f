// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/matrices/separated_bezoutian.hpp>

namespace eliminant::symbolic {

/// The rank of B over Q(u, t) and the greatest common divisor of its minors of that size, primitive.
struct BezoutianMinors {
  std::size_t rank = 0;
  Polynomial gcd{2};
};

/// Both proven: of a symmetric matrix of rank r some principal minor of size r is not zero; all larger ones are shown
/// to vanish, and the gcd of all principal ones is that of all (the minors of rows I and columns J are c w_I w_J, the
/// w_I without a common factor). As many determinants as there are sets of r rows, at most: for small matrices.
BezoutianMinors bezoutian_minors(const SeparatedBezoutian& matrix, std::uint64_t seed, const Context& context);

}  // namespace eliminant::symbolic
