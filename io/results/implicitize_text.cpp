// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/implicitize_text.hpp>

#include <algorithm>
#include <string_view>

#include <eliminant/io/results/implicitize_words.hpp>
#include <eliminant/io/results/representation_json.hpp>
#include <eliminant/io/results/text_sections.hpp>
#include <eliminant/io/results/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::PieceRepresentation;
using Rows = std::vector<std::vector<std::string>>;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string status_line(const intersect::ImplicitizeResult& result) {
  if (result.limit) return "Status: incomplete: " + *result.limit + "\n";
  if (result.status == intersect::Status::certified) return "Status: certified: ranks and degrees are proven\n";
  return "Status: numeric: ranks and degrees were found modulo a 62-bit prime, not all are proven\n";
}

std::string title(const PieceRepresentation& piece) {
  const std::string_view kind = kind_word(piece);
  if (kind == "plane_curve") return "Matrix representation of a plane curve by moving lines";
  if (kind == "space_curve") return "Matrix representation of a space curve by moving planes";
  if (kind == "triangular_surface")
    return "Matrix representation of a surface over the projective plane by moving planes";
  return "Matrix representation of a tensor-product surface by moving planes";
}

std::string interval_text(const symbolic::Interval& interval) {
  return "[" + interval.lower.to_string() + ", " + interval.upper.to_string() + "]";
}

std::string domain_text(const symbolic::CurvePiece& piece) { return piece.domain ? interval_text(*piece.domain) : ""; }

std::string domain_text(const symbolic::SurfacePiece& piece) {
  if (!piece.region) return "";
  if (piece.region->triangle) return "triangle";
  return interval_text(piece.region->sides[0]) + " x " + interval_text(piece.region->sides[1]);
}

std::string facts(const PieceRepresentation& piece) {
  const bool surface = std::holds_alternative<symbolic::SurfacePiece>(piece.piece);
  const std::string thing = surface ? "surface" : "curve";
  std::string nu;
  for (const long degree : piece.nu) nu += (nu.empty() ? "" : ", ") + std::to_string(degree);
  Rows rows{{"degree nu of the rows", piece.nu.size() > 1 ? "(" + nu + ")" : nu},
            {"rows x columns", std::to_string(piece.matrix.rows()) + " x " + std::to_string(piece.matrix.columns())},
            {"rank", std::to_string(piece.rank_off) + " in general, " + std::to_string(piece.rank_on) + " on the " +
                         thing + " (modulo a 62-bit prime)"}};
  if (piece.represents) {
    rows.push_back({"degree of the " + thing, std::to_string(piece.degree())});
    rows.push_back({"degree of the map", std::to_string(piece.map_degree) + ", product of both " +
                                             std::to_string(piece.product) + (piece.proven ? "" : " (not proven)")});
  }
  if (piece.represents && piece.minors)
    rows.push_back({"degree of the minors' gcd",
                    std::to_string(*piece.minors) +
                        (piece.extraneous ? ": planes of base points besides the surface" : ": no extraneous factor")});
  if (!piece.represents) rows.push_back({"represents", "nothing: the rank is below the number of rows everywhere"});
  rows.push_back({"monomials of the rows", joined(monomial_texts(piece.matrix, parameter_names(piece)))});
  return text_table(rows, {});
}

/// As a table where it is narrow enough, else column by column.
std::string matrix_text(const PieceRepresentation& piece) {
  const Rows forms = linear_forms(piece.matrix);
  if (table_width(forms) <= widest_table)
    return "\n" + text_table(forms, std::vector<bool>(forms.front().size(), true));
  const std::vector<std::string> monomials = monomial_texts(piece.matrix, parameter_names(piece));
  std::string text;
  for (std::size_t j = 0; j < forms.front().size(); ++j) {
    text += "\n  column " + std::to_string(j + 1) + "\n";
    for (std::size_t i = 0; i < forms.size(); ++i)
      if (forms[i][j] != "0") text += "    " + monomials[i] + ": " + forms[i][j] + "\n";
  }
  return text;
}

std::string piece_text(const PieceRepresentation& piece, std::size_t number, std::size_t count) {
  const std::string domain = std::visit([](const auto& given) { return domain_text(given); }, piece.piece);
  std::string text = "\n" + title(piece);
  if (count > 1) text += ", piece " + std::to_string(number) + " of " + std::to_string(count);
  if (!domain.empty()) text += ", domain " + domain;
  text += "\n" + facts(piece) + (piece.matrix.columns() > 0 ? matrix_text(piece) : "\n  no columns\n");
  if (piece.equation) text += "\nImplicit equation (proven)\n  " + equation_text(piece) + " = 0\n";
  return text;
}

}  // namespace

std::string implicitize_text(const intersect::ImplicitizeResult& result, bool with_seconds) {
  std::string text = status_line(result);
  for (std::size_t i = 0; i < result.pieces.size(); ++i)
    text += piece_text(result.pieces[i], i + 1, result.pieces.size());
  if (with_seconds) text += "\n" + seconds_line(result.seconds);
  return text;
}

}  // namespace eliminant::io
