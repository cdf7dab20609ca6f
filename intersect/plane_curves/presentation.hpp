// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/intersect/plane_curves/solution_set.hpp>

namespace eliminant::intersect {

/// Bits that hold a number of decimal digits, the guard digits of rounding, and a few more.
constexpr long bits_for_digits(long digits) { return digits * 10 / 3 + 28; }

/// The points of `set` with the given indices as solutions with `digits` significant decimal digits, sorted by
/// (Re x, Im x, Re y, Im y) as printed. Where the printed boxes of two
/// solutions would meet, both get more digits until they do not; nor is a real point of the set that is not listed in
/// any. Fills everything but `certified` and `reason`.
std::vector<Solution> present(SolutionSet& set, const std::vector<std::size_t>& indices, long digits);

/// The same from the enclosures as they are, without any computation that could take long: radii are as large as the
/// enclosures make them, points without a significant digit are left out.
std::vector<Solution> present_as_enclosed(const SolutionSet& set, const std::vector<std::size_t>& indices, long digits);

}  // namespace eliminant::intersect
