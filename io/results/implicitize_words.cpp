// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/implicitize_words.hpp>

#include <variant>

#include <eliminant/io/results/representation_json.hpp>

namespace eliminant::io {

namespace {

using intersect::PieceRepresentation;
using symbolic::RationalSurface;

}  // namespace

const char* kind_word(const PieceRepresentation& piece) {
  if (const auto* curve = std::get_if<symbolic::CurvePiece>(&piece.piece))
    return curve->map.dimension() == 2 ? "plane_curve" : "space_curve";
  return std::get<symbolic::SurfacePiece>(piece.piece).map.kind() == RationalSurface::Kind::triangular
             ? "triangular_surface"
             : "tensor_product_surface";
}

std::vector<std::string> parameter_names(const PieceRepresentation& piece) {
  const auto* surface = std::get_if<symbolic::SurfacePiece>(&piece.piece);
  if (surface == nullptr) return {"t"};
  if (surface->map.kind() == RationalSurface::Kind::triangular) return {"s", "t", "u"};
  return {"s", "t"};
}

std::string equation_text(const PieceRepresentation& piece) {
  return symbolic::to_string(*piece.equation, coordinate_names(piece.equation->variable_count()));
}

}  // namespace eliminant::io
