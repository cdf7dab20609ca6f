// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/curve_topology_csv.hpp>

#include <eliminant/io/results/curve_topology_words.hpp>
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

std::string curve_topology_csv(const intersect::TopologyResult& result) {
  const auto word = [](bool value) { return value ? "true" : "false"; };
  std::string out = "kind,type,x,y,radius,left,right,vertical,milnor_number,on_border,certified\n";
  for (const intersect::TopologyVertex& vertex : result.vertices) {
    const bool singular = vertex.kind == intersect::VertexKind::singular;
    out += std::string(word_for(vertex.kind)) + "," + (singular ? singularity_word(vertex) : "") + ",";
    out += x_text(vertex) + "," + y_text(vertex) + ",";
    out += (vertex.x_infinite == 0 ? radius_text(vertex.radius_exponent) : "") + ",";
    out += std::to_string(vertex.left) + "," + std::to_string(vertex.right) + "," + std::to_string(vertex.vertical) +
           "," + std::to_string(vertex.milnor_number) + "," + word(vertex.on_border) + "," + word(vertex.certified) +
           "\n";
  }
  return out;
}

}  // namespace eliminant::io
