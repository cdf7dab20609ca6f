// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include <eliminant/intersect/patches/branch_components.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using bridge::BranchGraph;
using bridge::CellBox;

namespace {

BranchGraph graph_of(std::size_t points, const std::vector<std::array<std::size_t, 2>>& arcs) {
  BranchGraph graph;
  graph.points.resize(points);
  for (const auto& [from, to] : arcs) graph.arcs.push_back({from, to, {}, {}, {}});
  return graph;
}

/// Follows the arcs from the start: where that leads, by every point met.
std::vector<std::size_t> walk(const BranchGraph& graph, const BranchChain& chain) {
  std::vector<std::size_t> points{chain.start};
  for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
    const bridge::CellArc& arc = graph.arcs[chain.arcs[i]];
    CHECK((chain.reversed[i] ? arc.to : arc.from) == points.back());
    points.push_back(chain.reversed[i] ? arc.from : arc.to);
  }
  CHECK(points.back() == chain.end);
  return points;
}

CellBox cube(double lower, double upper) {
  CellBox box;
  box.lower.fill(lower);
  box.upper.fill(upper);
  return box;
}

}  // namespace

TEST_CASE("Branch chains: arcs of any direction become one way from end to end") {
  const BranchGraph graph = graph_of(4, {{2, 3}, {1, 2}, {1, 0}});
  const auto chains = branch_chains(graph);
  REQUIRE(chains.size() == 1);
  CHECK_FALSE(chains[0].closed);
  CHECK(walk(graph, chains[0]) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(chains[0].arcs == std::vector<std::size_t>{2, 1, 0});
}

TEST_CASE("Branch chains: loops, also of two arcs and of one, after those with ends") {
  const BranchGraph graph = graph_of(9, {{0, 1}, {2, 1}, {2, 0}, {3, 4}, {3, 4}, {5, 5}, {8, 7}});
  const auto chains = branch_chains(graph);
  REQUIRE(chains.size() == 4);
  CHECK(walk(graph, chains[0]) == std::vector<std::size_t>{7, 8});
  for (std::size_t i = 1; i < 4; ++i) {
    CHECK(chains[i].closed);
    CHECK(chains[i].start == chains[i].end);
    CHECK(chains[i].arcs.size() == 4 - i);
    walk(graph, chains[i]);
  }
}

TEST_CASE("Branch chains: ways end at points where four arcs meet, and every arc is used once") {
  // Two ways through 4, and a loop that begins and ends there, with 5 on it.
  const BranchGraph graph = graph_of(6, {{0, 4}, {4, 1}, {4, 5}, {5, 4}});
  const auto chains = branch_chains(graph);
  REQUIRE(chains.size() == 3);
  std::vector<std::size_t> used;
  for (const BranchChain& chain : chains) {
    walk(graph, chain);
    used.insert(used.end(), chain.arcs.begin(), chain.arcs.end());
  }
  std::sort(used.begin(), used.end());
  CHECK(used == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(chains[0].end == 4);
  CHECK(chains[1].end == 4);
  CHECK(chains[2].start == 4);
  CHECK(chains[2].end == 4);
  CHECK(chains[2].arcs.size() == 2);
}

TEST_CASE("Clusters: boxes that touch are one hull, also when the last joins two") {
  CHECK(clusters_of({}).empty());
  const auto apart = clusters_of({cube(0, 1), cube(2, 3)});
  CHECK(apart.size() == 2);
  const auto joined = clusters_of({cube(0, 1), cube(2, 3), cube(5, 6), cube(1, 2)});
  REQUIRE(joined.size() == 2);
  const auto hull = std::find_if(joined.begin(), joined.end(), [](const CellBox& box) { return box.lower[0] == 0; });
  REQUIRE(hull != joined.end());
  CHECK(hull->upper == std::array<double, 4>{3, 3, 3, 3});
  // Apart in one parameter is apart.
  CellBox aside = cube(0, 1);
  aside.lower[3] = 2;
  aside.upper[3] = 3;
  CHECK(clusters_of({cube(0, 1), aside}).size() == 2);
}
