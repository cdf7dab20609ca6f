// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/implicitize_json.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/io/results/implicitize_words.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/representation_json.hpp>
#include <eliminant/io/results/result_fields.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;

Json interval_json(const symbolic::Interval& interval) {
  return Json::array({interval.lower.to_string(), interval.upper.to_string()});
}

/// The field `domain`, absent where there is none.
void add_domain(Json& out, const symbolic::CurvePiece& piece) {
  if (piece.domain) out["domain"] = interval_json(*piece.domain);
}

void add_domain(Json& out, const symbolic::SurfacePiece& piece) {
  if (!piece.region) return;
  if (piece.region->triangle)
    out["domain"] = "triangle";
  else
    out["domain"] = Json::array({interval_json(piece.region->sides[0]), interval_json(piece.region->sides[1])});
}

void add_coordinates(Json& out, const symbolic::RationalCurve& map) {
  const std::vector<std::string> names{"t"};
  for (std::size_t k = 0; k < map.coordinates().size(); ++k) {
    std::vector<symbolic::Polynomial::Term> terms;
    for (long i = 0; i <= map.coordinates()[k].degree(); ++i)
      terms.push_back({map.coordinates()[k].coefficient(i), {static_cast<unsigned long>(i)}});
    out[coordinate_names(map.coordinates().size())[k]] =
        symbolic::to_string(symbolic::Polynomial::from_terms(1, terms), names);
  }
}

void add_coordinates(Json& out, const symbolic::RationalSurface& map) { add_map(out, map); }

Json piece_json(const intersect::PieceRepresentation& piece) {
  Json out;
  out["kind"] = kind_word(piece);
  std::visit([&](const auto& given) { add_domain(out, given); }, piece.piece);
  out["parameters"] = parameter_names(piece);
  std::visit([&](const auto& given) { add_coordinates(out, given.map); }, piece.piece);
  out["nu"] = piece.nu;
  out["rows"] = piece.matrix.rows();
  out["columns"] = piece.matrix.columns();
  out["rank"] = piece.rank_off;
  out["rank_on"] = piece.rank_on;
  out["represents"] = piece.represents;
  if (piece.represents) {
    out["degree"] = piece.degree();
    out["map_degree"] = piece.map_degree;
    out["product"] = piece.product;
    if (piece.minors) out["minors"] = *piece.minors;
    if (piece.minors) out["extraneous"] = piece.extraneous;
  }
  out["proven"] = piece.proven;
  out["row_monomials"] = monomial_texts(piece.matrix, parameter_names(piece));
  out["matrix"] = matrix_json(piece.matrix);
  if (piece.equation) out["equation"] = equation_text(piece);
  return out;
}

}  // namespace

std::string implicitize_json(const intersect::ImplicitizeResult& result, const std::optional<ProblemId>& id) {
  Json out = result_heading("implicitize", id, result.status, {}, result.limit);
  out["counts"] = {{"pieces", result.pieces.size()}};
  out["representations"] = Json::array();
  for (const intersect::PieceRepresentation& piece : result.pieces) out["representations"].push_back(piece_json(piece));
  out["engine"] = engine_json(result.engine);
  if (!result.seconds.empty()) out["seconds"] = seconds_json(result.seconds);
  out["warnings"] = result.warnings;
  return json_layout(out);
}

}  // namespace eliminant::io
