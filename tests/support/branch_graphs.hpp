// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include <support/text_patches.hpp>

#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/branches/patch_border_points.hpp>

/// Intersections of patches as graphs, without an exact stage for what doubles cannot tell.
namespace eliminant::test {

inline bridge::BorderPoints border_points(const NetPair& nets) {
  const Context context;
  return bridge::patch_border_points(
      nets.first, nets.second, nets.exact_first, nets.exact_second,
      [](std::size_t, int, std::size_t, int) { return std::vector<std::array<double, 2>>(); },
      [](std::size_t, int) { return bridge::ContainedParts(); }, context);
}

inline bridge::BranchGraph branch_graph(const NetPair& nets, const bridge::SurfaceContactProver* contacts = nullptr,
                                        const bridge::BranchLimits& limits = {}) {
  const Context context;
  std::vector<bridge::CrossingPoint> ends;
  for (const bridge::BorderPoint& point : border_points(nets).points)
    if (point.arcs == 1) ends.push_back(point);
  return bridge::branch_subdivision(nets.first, nets.second, ends, {}, contacts, limits, context);
}

/// Curves with two ends and closed ones, of a graph without contacts.
struct CurveCount {
  std::size_t open = 0;
  std::size_t closed = 0;
  friend bool operator==(const CurveCount&, const CurveCount&) = default;
};

inline CurveCount count_curves(const bridge::BranchGraph& graph) {
  std::vector<std::size_t> root(graph.points.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  std::vector<std::size_t> degree(graph.points.size());
  for (const bridge::CellArc& arc : graph.arcs) {
    ++degree[arc.from];
    ++degree[arc.to];
    root[find(arc.from)] = find(arc.to);
  }
  CurveCount count;
  count.open = static_cast<std::size_t>(std::count(degree.begin(), degree.end(), 1U)) / 2;
  for (std::size_t i = 0; i < root.size(); ++i)
    if (root[i] == i && degree[i] > 0) ++count.closed;
  count.closed -= count.open;
  return count;
}

}  // namespace eliminant::test
