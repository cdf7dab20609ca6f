// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/intersect/solution_set.hpp>

namespace eliminant::intersect {

/// The points of `set` with the given indices as solutions with `digits` significant decimal digits, sorted by
/// (Re x, Im x, Re y, Im y). Where the printed boxes of two solutions would meet, both get more digits until they do
/// not. Fills everything but `certified` and `reason`.
std::vector<Solution> present(SolutionSet& set, const std::vector<std::size_t>& indices, long digits);

}  // namespace eliminant::intersect
