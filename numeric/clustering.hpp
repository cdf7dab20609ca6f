// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include <eliminant/numeric/scalar.hpp>

namespace eliminant::numeric {

/// Indices of the values of one cluster, ascending.
using Cluster = std::vector<long>;

/// When to stop joining clusters: at a known number of them, or at a distance.
template <class Scalar>
struct ClusteringRule {
  long count = 0;       ///< stop at this many clusters
  Scalar distance = 0;  ///< or, where positive, when the next join is farther than this (the paper's epsilon)
};

/// Single-linkage clustering of complex numbers in the distance |a - b| / max(1, |a|, |b|). Clusters are ordered by
/// their smallest index. Source: step 3 of Algorithm 2 of [BuseKhalilMourrain2005] for a given distance; with a count
/// the exact number of distinct eigenvalues replaces the tolerance.
template <class Scalar>
std::vector<Cluster> cluster_values(const Vector<std::complex<Scalar>>& values, const ClusteringRule<Scalar>& rule) {
  const long n = values.size();
  std::vector<long> parent(static_cast<std::size_t>(n));
  for (long i = 0; i < n; ++i) parent[static_cast<std::size_t>(i)] = i;
  const auto root = [&](long i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  // Prim's minimum spanning tree, then its edges by increasing length (single linkage is Kruskal's algorithm on them).
  struct Edge {
    Scalar length;
    long from, to;
  };
  std::vector<Edge> edges;
  if (n > 1) {
    std::vector<Scalar> size(static_cast<std::size_t>(n));
    for (long i = 0; i < n; ++i)
      size[static_cast<std::size_t>(i)] = std::max(Scalar(1), Scalar(modulus<Scalar>(values(i))));
    const auto distance = [&](long i, long j) {
      const Scalar scale = std::max(size[static_cast<std::size_t>(i)], size[static_cast<std::size_t>(j)]);
      return Scalar(modulus<Scalar>(std::complex<Scalar>(values(i) - values(j))) / scale);
    };
    std::vector<Edge> nearest(static_cast<std::size_t>(n));
    std::vector<bool> inside(static_cast<std::size_t>(n), false);
    inside[0] = true;
    for (long j = 1; j < n; ++j) nearest[static_cast<std::size_t>(j)] = {distance(0, j), 0, j};
    for (long step = 1; step < n; ++step) {
      long best = -1;
      for (long j = 0; j < n; ++j)
        if (!inside[static_cast<std::size_t>(j)] &&
            (best < 0 || nearest[static_cast<std::size_t>(j)].length < nearest[static_cast<std::size_t>(best)].length))
          best = j;
      inside[static_cast<std::size_t>(best)] = true;
      edges.push_back(nearest[static_cast<std::size_t>(best)]);
      for (long j = 0; j < n; ++j) {
        if (inside[static_cast<std::size_t>(j)]) continue;
        const Scalar length = distance(best, j);
        if (length < nearest[static_cast<std::size_t>(j)].length)
          nearest[static_cast<std::size_t>(j)] = {length, best, j};
      }
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.length < b.length; });
  long clusters = n;
  for (const Edge& edge : edges) {
    const bool stop = rule.distance > 0 ? edge.length > rule.distance : clusters <= rule.count;
    if (stop) break;
    const long a = root(edge.from);
    const long b = root(edge.to);
    parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    --clusters;
  }
  std::vector<Cluster> result;
  std::vector<long> position(static_cast<std::size_t>(n), -1);
  for (long i = 0; i < n; ++i) {
    long& place = position[static_cast<std::size_t>(root(i))];
    if (place < 0) {
      place = static_cast<long>(result.size());
      result.emplace_back();
    }
    result[static_cast<std::size_t>(place)].push_back(i);
  }
  return result;
}

}  // namespace eliminant::numeric
