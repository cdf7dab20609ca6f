// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/curve_topology_text.hpp>

#include <algorithm>
#include <vector>

#include <eliminant/io/results/curve_topology_words.hpp>
#include <eliminant/io/results/result_words.hpp>
#include <eliminant/io/results/text_sections.hpp>
#include <eliminant/io/results/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::TopologyResult;
using intersect::TopologyVertex;
using Rows = std::vector<std::vector<std::string>>;

std::string status_line(const TopologyResult& result) {
  if (result.limit) return "Status: incomplete: " + *result.limit + "\n";
  return result.status == intersect::Status::certified
             ? "Status: certified: every vertex and every arc proven, none missing\n"
             : "Status: numeric: computed, not proven complete\n";
}

std::string summary(const TopologyResult& result) {
  return "\nThe curve has\n" + text_table({{std::to_string(result.counts.components), "connected components"},
                                           {std::to_string(result.loops.size()), "of them simple closed curves"},
                                           {std::to_string(result.isolated.size()), "of them points"},
                                           {std::to_string(result.counts.cycles), "independent cycles"},
                                           {std::to_string(result.counts.faces), "faces of the complement"},
                                           {std::to_string(result.counts.singular), "singular points"},
                                           {std::to_string(result.counts.infinity), "ends at infinity"}},
                                          {true, false});
}

void add_column(Rows& rows, const std::vector<std::string>& column) {
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(column[i]);
}

std::string kind_text(const TopologyVertex& vertex) {
  std::string text = word_for(vertex.kind);
  if (vertex.kind == intersect::VertexKind::singular) text += std::string(", ") + singularity_word(vertex);
  if (vertex.on_border && vertex.kind != intersect::VertexKind::border) text += ", on the border";
  return text;
}

std::string vertex_table(const TopologyResult& result) {
  if (result.vertices.empty()) return "";
  Rows rows{{"#"}};
  for (std::size_t i = 0; i < result.vertices.size(); ++i) rows.push_back({std::to_string(i)});
  const auto add = [&](const std::string& name, auto text_of) {
    std::vector<std::string> column{name};
    for (const TopologyVertex& vertex : result.vertices) column.push_back(text_of(vertex));
    add_column(rows, column);
  };
  const auto add_numbers = [&](const std::string& name, auto text_of) {
    std::vector<std::string> numbers;
    for (const TopologyVertex& vertex : result.vertices) numbers.push_back(text_of(vertex));
    add_column(rows, number_column(name, std::move(numbers)));
  };
  const auto finite = [](const TopologyVertex& vertex) { return vertex.kind != intersect::VertexKind::infinity; };
  add_numbers(result.variables[0], x_text);
  add_numbers(result.variables[1], [](const TopologyVertex& v) { return y_text(v).empty() ? "-" : y_text(v); });
  add("kind", kind_text);
  add("left", [&](const TopologyVertex& v) { return finite(v) ? std::to_string(v.left) : "-"; });
  add("right", [&](const TopologyVertex& v) { return finite(v) ? std::to_string(v.right) : "-"; });
  const bool lines = std::any_of(result.vertices.begin(), result.vertices.end(),
                                 [](const TopologyVertex& v) { return v.vertical > 0; });
  if (lines) add("vertical", [&](const TopologyVertex& v) { return finite(v) ? std::to_string(v.vertical) : "-"; });
  add("Milnor", [&](const TopologyVertex& v) { return finite(v) ? std::to_string(v.milnor_number) : "-"; });
  add("radius", [](const TopologyVertex& v) { return v.x_infinite == 0 ? radius_text(v.radius_exponent) : "-"; });
  std::vector<bool> right_aligned(rows.front().size(), false);
  right_aligned.front() = true;
  return "\nVertices, with the number of half-branches on each side\n" + text_table(rows, right_aligned);
}

std::string edge_lines(const TopologyResult& result) {
  if (result.edges.empty()) return "";
  Rows rows{{"#", "from", "to", "points"}};
  for (std::size_t i = 0; i < result.edges.size(); ++i) {
    const intersect::TopologyEdge& edge = result.edges[i];
    rows.push_back(
        {std::to_string(i), std::to_string(edge.from), std::to_string(edge.to), std::to_string(edge.polyline.size())});
  }
  std::string text = "\nEdges\n" + text_table(rows, std::vector<bool>(4, true));
  for (const auto& loop : result.loops) {
    text += "Simple closed curve: edges";
    for (const std::size_t edge : loop) text += " " + std::to_string(edge);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string curve_topology_text(const TopologyResult& result, const RunOptions& options) {
  std::string text = status_line(result) + summary(result) + given_and_used(result.engine, options);
  text += vertex_table(result) + edge_lines(result);
  if (!result.isolated.empty()) {
    text += "Isolated: vertices";
    for (const std::size_t vertex : result.isolated) text += " " + std::to_string(vertex);
    text += "\n";
  }
  return text + "\n" + seconds_line(result.seconds);
}

}  // namespace eliminant::io
