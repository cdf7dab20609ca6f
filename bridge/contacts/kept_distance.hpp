// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// Whether no pair of parameters in the box has a common point, as the parts keep a distance along their normals. False
/// decides nothing.
///
/// Proven in one of two ways. The height h of one part above the other is monotone or convex enough not to reach zero
/// (TangentialElimination): for parts that bend differently, however near they come. Or the parameters q(p) of the
/// point opposite are a polynomial of degree five, and what is left of A(p) - B(q(p)) is a vector whose part along the
/// normal is larger than the slopes of B allow between any two of its points (Taylor models): for parts that are nearly
/// parallel, however large.
bool keep_distance(const ControlNet& first, const ControlNet& second, const CellBox& box);

/// The same of two patches as a whole, cut into parts where needed. It gives up early where they seem to meet, and
/// where they are not nearly parallel from the start.
bool keep_distance(const ControlNet& first, const ControlNet& second);

}  // namespace eliminant::bridge
