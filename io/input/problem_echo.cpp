// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/problem_echo.hpp>

#include <array>
#include <nlohmann/json.hpp>
#include <variant>

#include <eliminant/io/results/curve_topology_words.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/univariate_text.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

constexpr std::array plane_coordinates{"x", "y", "w"};
constexpr std::array space_coordinates{"x", "y", "z", "w"};

Json interval_json(const symbolic::Interval& interval) {
  return Json::array({interval.lower.to_string(), interval.upper.to_string()});
}

Json piece_json(const symbolic::CurvePiece& piece) {
  Json out;
  out["parameter"] = "t";
  const auto& coordinates = piece.map.coordinates();
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    out[coordinates.size() == 3 ? plane_coordinates[i] : space_coordinates[i]] = univariate_text(coordinates[i], "t");
  if (piece.domain) out["domain"] = interval_json(*piece.domain);
  return out;
}

Json piece_json(const symbolic::SurfacePiece& piece) {
  const Names names =
      piece.map.kind() == symbolic::RationalSurface::Kind::triangular ? Names{"s", "t", "u"} : Names{"s", "t"};
  Json out;
  out["parameters"] = names;
  for (std::size_t i = 0; i < space_coordinates.size(); ++i)
    out[space_coordinates[i]] = symbolic::to_string(piece.map.coordinates()[i], names);
  if (piece.region && piece.region->triangle)
    out["domain"] = "triangle";
  else if (piece.region)
    out["domain"] = Json::array({interval_json(piece.region->sides[0]), interval_json(piece.region->sides[1])});
  return out;
}

template <class Geometry>
Json pieces_json(const Geometry& geometry) {
  if (geometry.pieces.size() == 1) return piece_json(geometry.pieces.front());
  Json out;
  out["pieces"] = Json::array();
  for (const auto& piece : geometry.pieces) out["pieces"].push_back(piece_json(piece));
  return out;
}

Json geometry_json(const intersect::Curve& curve) {
  if (const auto* implicit = std::get_if<intersect::ImplicitCurve>(&curve))
    return {{"implicit", symbolic::to_string(implicit->equation, Names{"x", "y"})}};
  return pieces_json(std::get<symbolic::ParametricCurve>(curve));
}

Json equation_json(const symbolic::Polynomial& equation) {
  return {{"implicit", symbolic::to_string(equation, Names{"x", "y", "z"})}};
}

Json geometry_json(const intersect::Surface& surface) {
  if (const auto* implicit = std::get_if<intersect::ImplicitSurface>(&surface))
    return equation_json(implicit->equation);
  return pieces_json(std::get<symbolic::ParametricSurface>(surface));
}

Json geometry_json(const std::variant<symbolic::ParametricSurface, symbolic::Polynomial>& surface) {
  if (const auto* equation = std::get_if<symbolic::Polynomial>(&surface)) return equation_json(*equation);
  return pieces_json(std::get<symbolic::ParametricSurface>(surface));
}

void echo_box(Json& out, const std::optional<intersect::Box>& box) {
  if (!box) return;
  out["box"] = Json::array();
  for (const auto& side : {box->x, box->y})
    out["box"].push_back(Json::array({side[0].to_string(), side[1].to_string()}));
}

void echo(Json& out, const intersect::PlaneCurvesProblem& problem) {
  out["variables"] = problem.variables;
  out["p"] = symbolic::to_string(problem.p, problem.variables);
  out["q"] = symbolic::to_string(problem.q, problem.variables);
  echo_box(out, problem.box);
}

void echo(Json& out, const intersect::CurveTopologyProblem& problem) {
  out["variables"] = problem.variables;
  out["p"] = symbolic::to_string(problem.p, problem.variables);
  echo_box(out, problem.box);
}

void echo(Json& out, const intersect::CurveSurfaceProblem& problem) {
  out["curve"] = pieces_json(problem.curve);
  out["surface"] = geometry_json(problem.surface);
}

void echo(Json& out, const intersect::CurveCurveProblem& problem) {
  out["first"] = geometry_json(problem.first);
  out["second"] = geometry_json(problem.second);
}

void echo(Json& out, const intersect::SelfIntersectionProblem& problem) { out["curve"] = geometry_json(problem.curve); }

void echo(Json& out, const intersect::SurfaceSurfaceProblem& problem) {
  out["first"] = geometry_json(problem.first);
  out["second"] = geometry_json(problem.second);
}

void echo(Json& out, const intersect::SurfaceSelfIntersectionProblem& problem) {
  out["surface"] = pieces_json(problem.surface);
}

void echo(Json& out, const intersect::ImplicitizeProblem& problem) {
  if (const auto* curve = std::get_if<symbolic::ParametricCurve>(&problem.geometry))
    out["curve"] = pieces_json(*curve);
  else
    out["surface"] = pieces_json(std::get<symbolic::ParametricSurface>(problem.geometry));
}

void echo(Json& out, const intersect::CylindersProblem& problem) {
  out["points"] = Json::array();
  for (const symbolic::SpacePoint& point : problem.points)
    out["points"].push_back(Json::array({point[0].to_string(), point[1].to_string(), point[2].to_string()}));
}

void echo(Json& out, const intersect::CylinderExtractionProblem& problem) {
  out["cloud"] = problem.cloud;
  out["distance"] = double_text(problem.distance);
  if (problem.min_radius) out["min_radius"] = double_text(*problem.min_radius);
  if (problem.max_radius) out["max_radius"] = double_text(*problem.max_radius);
  if (problem.min_inliers) out["min_inliers"] = *problem.min_inliers;
  out["confidence"] = double_text(problem.confidence);
}

}  // namespace

std::string echo_problem(const ProblemFile& file, const RunOptions& options) {
  constexpr std::array kinds{"plane_curves", "curve_surface",      "curve_curve",     "self_intersection",
                             "implicitize",  "curve_topology",     "surface_surface", "self_intersection",
                             "cylinders",    "cylinder_extraction"};
  static_assert(kinds.size() == std::variant_size_v<Problem>);
  Json out;
  out["problem"] = kinds[file.problem.index()];
  if (file.id) std::visit([&](const auto& id) { out["id"] = id; }, *file.id);
  std::visit([&](const auto& problem) { echo(out, problem); }, file.problem);
  for (const auto& [name, value, place] : settings_of(options)) {
    if (is_switch(name))
      out["options"][name] = value == "true";
    else
      out["options"][name] = value;
  }
  return json_layout(out);
}

}  // namespace eliminant::io
