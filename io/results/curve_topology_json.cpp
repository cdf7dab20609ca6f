// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/curve_topology_json.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/io/results/curve_topology_words.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/result_fields.hpp>
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;

Json coordinate_of(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json vertex_json(const intersect::TopologyVertex& vertex) {
  Json out;
  out["kind"] = word_for(vertex.kind);
  if (vertex.kind == intersect::VertexKind::singular) out["type"] = singularity_word(vertex);
  out["x"] = coordinate_of(x_text(vertex));
  out["y"] = coordinate_of(y_text(vertex));
  const bool located = vertex.x_infinite == 0;
  out["radius"] = located ? Json(radius_text(vertex.radius_exponent)) : Json();
  if (vertex.kind != intersect::VertexKind::infinity) {
    out["half_branches"] = {{"left", vertex.left}, {"right", vertex.right}, {"vertical", vertex.vertical}};
    out["milnor_number"] = vertex.milnor_number;
  }
  out["on_border"] = vertex.on_border;
  out["certified"] = vertex.certified;
  return out;
}

Json edge_json(const intersect::TopologyEdge& edge) {
  Json polyline = Json::array();
  for (const auto& [x, y] : edge.polyline) polyline.push_back(Json::array({double_text(x), double_text(y)}));
  return {{"from", edge.from}, {"to", edge.to}, {"polyline", std::move(polyline)}};
}

}  // namespace

std::string curve_topology_json(const intersect::TopologyResult& result, const std::optional<ProblemId>& id) {
  Json out = result_heading(result.problem, id, result.status, {}, result.limit);
  out["variables"] = result.variables;
  out["counts"] = {{"components", result.counts.components}, {"loops", result.loops.size()},
                   {"isolated", result.isolated.size()},     {"cycles", result.counts.cycles},
                   {"faces", result.counts.faces},           {"edges", result.edges.size()},
                   {"singular", result.counts.singular},     {"critical", result.counts.critical},
                   {"border", result.counts.border},         {"infinity", result.counts.infinity}};
  out["vertices"] = Json::array();
  for (const intersect::TopologyVertex& vertex : result.vertices) out["vertices"].push_back(vertex_json(vertex));
  out["edges"] = Json::array();
  for (const intersect::TopologyEdge& edge : result.edges) out["edges"].push_back(edge_json(edge));
  out["loops"] = result.loops;
  out["isolated"] = result.isolated;
  out["error"] = double_text(result.error);
  out["engine"] = engine_json(result.engine);
  if (!result.seconds.empty()) out["seconds"] = seconds_json(result.seconds);
  out["warnings"] = result.warnings;
  return json_layout(out);
}

}  // namespace eliminant::io
