// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/branch_components.hpp>

#include <algorithm>

namespace eliminant::intersect {

namespace {

/// The arcs at every point, and which of them were followed.
class Walk {
 public:
  explicit Walk(const bridge::BranchGraph& graph)
      : graph_(graph),
        arcs_at_(graph.points.size()),
        ends_here_(graph.points.size(), false),
        done_(graph.arcs.size(), false) {
    for (const bridge::CellCrossing& crossing : graph.crossings) ends_here_[crossing.point] = true;
    for (const bridge::CellContact& contact : graph.contacts) ends_here_[contact.point] = true;
    for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
      arcs_at_[graph.arcs[i].from].push_back(i);
      arcs_at_[graph.arcs[i].to].push_back(i);
    }
  }

  std::vector<BranchChain> run() && {
    for (std::size_t point = 0; point < arcs_at_.size(); ++point)
      if (is_end(point))
        for (const std::size_t arc : arcs_at_[point])
          if (!done_[arc]) follow(point, arc);
    for (std::size_t arc = 0; arc < done_.size(); ++arc)
      if (!done_[arc]) follow(graph_.arcs[arc].from, arc);
    return std::move(chains_);
  }

 private:
  bool is_end(std::size_t point) const { return arcs_at_[point].size() != 2 || ends_here_[point]; }

  void follow(std::size_t start, std::size_t arc) {
    BranchChain chain;
    chain.start = start;
    std::size_t point = start;
    while (true) {
      done_[arc] = true;
      const bool reversed = graph_.arcs[arc].from != point;
      chain.arcs.push_back(arc);
      chain.reversed.push_back(reversed);
      point = reversed ? graph_.arcs[arc].from : graph_.arcs[arc].to;
      if (is_end(point)) break;
      const std::size_t next = arcs_at_[point][0] == arc ? arcs_at_[point][1] : arcs_at_[point][0];
      if (done_[next]) {
        chain.closed = point == start;
        break;
      }
      arc = next;
    }
    chain.end = point;
    chains_.push_back(std::move(chain));
  }

  const bridge::BranchGraph& graph_;
  std::vector<std::vector<std::size_t>> arcs_at_;
  /// Contacts (also cusps, with two arcs), and points at which a branch crosses a curve of contact.
  std::vector<bool> ends_here_;
  std::vector<bool> done_;
  std::vector<BranchChain> chains_;
};

bool touch(const bridge::CellBox& a, const bridge::CellBox& b) {
  for (std::size_t k = 0; k < 4; ++k) {
    const double slack = 0.5 * std::min(a.upper[k] - a.lower[k], b.upper[k] - b.lower[k]);
    if (a.lower[k] > b.upper[k] + slack || b.lower[k] > a.upper[k] + slack) return false;
  }
  return true;
}

}  // namespace

std::vector<BranchChain> branch_chains(const bridge::BranchGraph& graph) { return Walk(graph).run(); }

std::vector<bridge::CellBox> clusters_of(const std::vector<bridge::CellBox>& boxes) {
  std::vector<bridge::CellBox> hulls;
  for (bridge::CellBox hull : boxes) {
    // One box may join several clusters.
    for (bool grown = true; grown;) {
      const auto other = std::find_if(hulls.begin(), hulls.end(), [&](const auto& h) { return touch(h, hull); });
      grown = other != hulls.end();
      if (!grown) break;
      for (std::size_t k = 0; k < 4; ++k) {
        hull.lower[k] = std::min(hull.lower[k], other->lower[k]);
        hull.upper[k] = std::max(hull.upper[k], other->upper[k]);
      }
      hulls.erase(other);
    }
    hulls.push_back(hull);
  }
  return hulls;
}

}  // namespace eliminant::intersect
