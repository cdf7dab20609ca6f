// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/topology/curve_topology.hpp>

namespace eliminant::io {

/// `singular`, `critical`, `border`, `infinity`: the same words in every format.
const char* word_for(intersect::VertexKind kind);

/// Of a singular point: `isolated`, `node`, `cusp`, `tacnode`, or `other`.
const char* singularity_word(const intersect::TopologyVertex& vertex);

/// A coordinate as printed; `-inf`, `inf`, and empty where it has no value.
std::string x_text(const intersect::TopologyVertex& vertex);
std::string y_text(const intersect::TopologyVertex& vertex);

/// The shortest decimal text that reads back as the same double.
std::string double_text(double value);

}  // namespace eliminant::io
