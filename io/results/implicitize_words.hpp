// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <eliminant/intersect/curve_surface/implicitize.hpp>

namespace eliminant::io {

// What the texts and the JSON of `implicitize` say in the same words.

/// `plane_curve`, `space_curve`, `triangular_surface`, `tensor_product_surface`.
const char* kind_word(const intersect::PieceRepresentation& piece);

/// The names of the parameters: t; s, t; or s, t, u.
std::vector<std::string> parameter_names(const intersect::PieceRepresentation& piece);

/// The implicit equation, which must be there, without "= 0".
std::string equation_text(const intersect::PieceRepresentation& piece);

}  // namespace eliminant::io
