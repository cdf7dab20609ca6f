// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string_view>
#include <vector>

#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <support/curves.hpp>

/// Plane curves as graphs: what every result has to fulfil, and what does not depend on coordinates.
namespace eliminant::test {

using intersect::Box;
using intersect::TopologyResult;
using intersect::TopologyVertex;
using intersect::VertexKind;
using symbolic::Polynomial;
using symbolic::Rational;

inline TopologyResult topology(const Polynomial& p, const std::optional<Box>& box = {},
                               const intersect::Options& options = {}) {
  intersect::CurveTopologyProblem problem;
  problem.p = p;
  problem.box = box;
  const Context context;
  return intersect::curve_topology(problem, options, context);
}

inline TopologyResult topology(std::string_view p, const std::optional<Box>& box = {}) {
  return topology(curve(p), box);
}

inline Box box(const char* a, const char* b, const char* c, const char* d) {
  const auto number = [](const char* text) { return symbolic::parse_number(text); };
  return {{number(a), number(b)}, {number(c), number(d)}};
}

/// Half-branches and Milnor number of every singular point, sorted.
using SingularTypes = std::vector<std::array<unsigned long, 2>>;

inline SingularTypes singular_types(const TopologyResult& result) {
  SingularTypes types;
  for (const TopologyVertex& vertex : result.vertices)
    if (vertex.kind == VertexKind::singular) types.push_back({vertex.half_branches(), vertex.milnor_number});
  std::sort(types.begin(), types.end());
  return types;
}

/// What does not depend on the coordinates.
struct Shape {
  unsigned long components = 0;
  unsigned long cycles = 0;
  std::size_t loops = 0;
  std::size_t isolated = 0;
  unsigned long ends_at_infinity = 0;
  SingularTypes singular;

  friend bool operator==(const Shape&, const Shape&) = default;
};

inline std::ostream& operator<<(std::ostream& out, const Shape& shape) {
  out << shape.components << " components, " << shape.cycles << " cycles, " << shape.loops << " loops, "
      << shape.isolated << " isolated, " << shape.ends_at_infinity << " ends at infinity; singular:";
  for (const auto& [half_branches, milnor] : shape.singular) out << " (" << half_branches << ", " << milnor << ")";
  return out;
}

inline Shape shape_of(const TopologyResult& result) {
  return {result.counts.components, result.counts.cycles,   result.loops.size(),
          result.isolated.size(),   result.counts.infinity, singular_types(result)};
}

/// What every result has to fulfil, whatever the curve.
inline void check_graph(const TopologyResult& result, bool boxed) {
  CHECK(result.status == intersect::Status::certified);
  std::vector<unsigned long> degrees(result.vertices.size(), 0);
  for (const intersect::TopologyEdge& edge : result.edges) {
    CHECK(edge.from != edge.to);
    ++degrees.at(edge.from);
    ++degrees.at(edge.to);
    CHECK(edge.polyline.size() >= 2);
    // Vertical lines, and vertices that doubles cannot tell apart, have two points above each other.
    const bool steep = edge.polyline.size() == 2;
    for (std::size_t k = 0; k + 1 < edge.polyline.size(); ++k)
      CHECK(
          (edge.polyline[k][0] < edge.polyline[k + 1][0] || (steep && edge.polyline[k][0] == edge.polyline[k + 1][0])));
  }
  for (std::size_t v = 0; v < degrees.size(); ++v) {
    const TopologyVertex& vertex = result.vertices[v];
    CHECK(vertex.certified);
    const bool isolated = std::count(result.isolated.begin(), result.isolated.end(), v) == 1;
    CHECK((degrees[v] == 0) == isolated);
    if (vertex.kind == VertexKind::infinity)
      CHECK(degrees[v] == 1);
    else if (!vertex.on_border)
      CHECK(degrees[v] == vertex.half_branches());
    else
      CHECK(degrees[v] <= vertex.half_branches());
    CHECK((vertex.kind == VertexKind::singular) == (vertex.milnor_number > 0));
    if (boxed) CHECK(vertex.kind != VertexKind::infinity);
    if (!boxed) CHECK(!vertex.on_border);
  }
  CHECK(result.counts.singular + result.counts.critical + result.counts.border + result.counts.infinity ==
        result.vertices.size());
  CHECK(result.vertices.size() + result.counts.cycles == result.edges.size() + result.counts.components);
  for (const auto& loop : result.loops) {
    CHECK(loop.size() >= 2);
    std::vector<std::size_t> ends;
    for (const std::size_t edge : loop) ends.insert(ends.end(), {result.edges[edge].from, result.edges[edge].to});
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k < ends.size(); ++k) CHECK(ends[k] == ends[k ^ 1U]);
  }
}

inline Shape checked_shape(const Polynomial& p) {
  INFO(text(p));
  const TopologyResult result = topology(p);
  check_graph(result, false);
  return shape_of(result);
}

inline Shape checked_shape(std::string_view p) { return checked_shape(curve(p)); }

inline Polynomial x() { return Polynomial::variable(2, 0); }
inline Polynomial y() { return Polynomial::variable(2, 1); }
inline Polynomial number(const Rational& value) { return Polynomial::constant(2, value); }

inline Polynomial composed(const Polynomial& p, const Polynomial& first, const Polynomial& second) {
  const std::array images{first, second};
  return p.compose(images);
}

}  // namespace eliminant::test
