// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>

namespace eliminant::intersect {

/// Pieces of a surface meet along their sides, and a closed surface meets itself there: what is at one t is one
/// solution, with all parameters. On a side the pieces are one surface, whose multiplicity each of them knows;
/// multiplicities of sheets that the curve crosses inside their pieces, as `sheets_inside` tells of each solution, add
/// up. Stretches of the curve in neighbouring pieces become one.
void merge_pieces(CurveResult& result, const std::vector<bool>& sheets_inside, const Context& context);

}  // namespace eliminant::intersect
