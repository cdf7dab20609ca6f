// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial_matrix.hpp>

namespace eliminant::symbolic {

/// The structure at infinity of a square T(x) of degree m >= 1 with det T != 0: entry k - 1 is the number of Jordan
/// blocks of size at least k at infinity of its companion pencil (the Weyr characteristic). The sum is mn - deg det T.
///
/// The staircase of regular_part_staircase over a random 62-bit prime field: the numbers are those over Q except with
/// probability about (mn)^2 / 2^61, and only steer the numeric stage, whose results are checked by other means.
std::vector<long> infinite_structure_modulo(const PolynomialMatrix& t, std::uint64_t seed);

}  // namespace eliminant::symbolic
