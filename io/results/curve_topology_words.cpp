// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/curve_topology_words.hpp>

#include <array>
#include <charconv>

namespace eliminant::io {

const char* word_for(intersect::VertexKind kind) {
  switch (kind) {
    case intersect::VertexKind::singular:
      return "singular";
    case intersect::VertexKind::critical:
      return "critical";
    case intersect::VertexKind::border:
      return "border";
    case intersect::VertexKind::infinity:
      return "infinity";
  }
  return "";
}

const char* singularity_word(const intersect::TopologyVertex& vertex) {
  // Milnor numbers 1, 2 and 3 leave the types A1, A2 and A3 alone.
  if (vertex.half_branches() == 0) return "isolated";
  switch (vertex.milnor_number) {
    case 1:
      return "node";
    case 2:
      return "cusp";
    case 3:
      return "tacnode";
    default:
      return "other";
  }
}

std::string x_text(const intersect::TopologyVertex& vertex) {
  if (vertex.x_infinite != 0) return vertex.x_infinite < 0 ? "-inf" : "inf";
  return vertex.x.real;
}

std::string y_text(const intersect::TopologyVertex& vertex) {
  if (vertex.y_infinite != 0) return vertex.y_infinite < 0 ? "-inf" : "inf";
  return vertex.x_infinite != 0 ? "" : vertex.y.real;
}

std::string double_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

}  // namespace eliminant::io
