// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/bridge/branches/branch_subdivision.hpp>

namespace eliminant::intersect {

/// A way through the graph from end to end, or around.
struct BranchChain {
  /// Indices of arcs, in order, and whether each is followed from its `to` to its `from`.
  std::vector<std::size_t> arcs;
  std::vector<bool> reversed;
  /// Indices of points; equal for a loop.
  std::size_t start = 0;
  std::size_t end = 0;
  bool closed = false;
};

/// All of them: every arc belongs to exactly one. Those with ends come first, by the index of their start.
std::vector<BranchChain> branch_chains(const bridge::BranchGraph& graph);

/// Boxes that touch each other, together; each given by the hull.
std::vector<bridge::CellBox> clusters_of(const std::vector<bridge::CellBox>& boxes);

}  // namespace eliminant::intersect
