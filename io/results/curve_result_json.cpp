// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/curve_result_json.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/io/input/curve_shape.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/result_fields.hpp>
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;

Json counts_json(const intersect::CurveCounts& counts) {
  return {{"distinct", counts.distinct},
          {"real", counts.real},
          {"undecided", counts.undecided},
          {"inside", counts.inside},
          {"with_multiplicity", counts.with_multiplicity},
          {"expected", counts.within_domains_only ? nlohmann::ordered_json() : nlohmann::ordered_json(counts.expected)},
          {"listed", counts.listed}};
}

Json parameter_json(const intersect::Parameter& parameter) {
  return parameter ? coordinate_json(*parameter) : Json("inf");
}

Json preimages_json(const std::vector<std::vector<intersect::Parameter>>& preimages) {
  Json out = Json::array();
  for (const auto& preimage : preimages) {
    Json& values = out.emplace_back(Json::array());
    for (const intersect::Parameter& parameter : preimage) values.push_back(parameter_json(parameter));
  }
  return out;
}

Json solution_json(const intersect::CurveSolution& solution, const CurveShape& shape) {
  Json out;
  if (shape.t && solution.t) out["t"] = parameter_json(*solution.t);
  if (shape.u && solution.u) out["u"] = parameter_json(*solution.u);
  out["point"] = Json::array();
  for (const intersect::Coordinate& coordinate : solution.point) out["point"].push_back(coordinate_json(coordinate));
  if (shape.surface) out["surface_parameters"] = preimages_json(solution.surface_parameters);
  if (shape.itself) out["kind"] = solution.kind ? Json(word_for(*solution.kind)) : Json();
  out["multiplicity"] = solution.multiplicity;
  if (solution.eigenvalue_multiplicity) out["eigenvalue_multiplicity"] = *solution.eigenvalue_multiplicity;
  out["inside"] = solution.inside;
  out["radius"] = radius_text(solution.radius_exponent);
  out["real"] = reality_json(solution.reality);
  out["certified"] = solution.certified;
  if (!solution.certified && !solution.reason.empty()) out["reason"] = solution.reason;
  return out;
}

Json interval_json(const std::optional<intersect::ParameterInterval>& interval) {
  if (!interval) return "all";
  Json out = Json::array();
  for (const intersect::Parameter& end : *interval) out.push_back(end ? end->real : "inf");
  return out;
}

Json overlap_json(const intersect::Overlap& overlap, const CurveShape& shape) {
  Json out;
  if (shape.t) out["t"] = interval_json(overlap.t);
  if (shape.u) out["u"] = interval_json(overlap.u);
  out["certified"] = overlap.certified;
  return out;
}

Json singular_point_json(const intersect::SingularPoint& point) {
  Json out;
  out["point"] = Json::array();
  for (const intersect::Coordinate& coordinate : point.point) out["point"].push_back(coordinate_json(coordinate));
  out["parameters"] = Json::array();
  for (const intersect::Parameter& parameter : point.parameters) out["parameters"].push_back(parameter_json(parameter));
  out["multiplicity"] = point.multiplicity;
  out["real"] = reality_json(point.reality);
  return out;
}

}  // namespace

std::string curve_result_json(const intersect::CurveResult& result, const std::optional<ProblemId>& id) {
  const CurveShape shape = shape_of(result);
  Json out = result_heading(result.problem, id, result.status, result.rest_status, result.limit);
  out["counts"] = counts_json(result.counts);
  out["solutions"] = Json::array();
  for (const intersect::CurveSolution& solution : result.solutions)
    out["solutions"].push_back(solution_json(solution, shape));
  if (shape.itself && shape.t) {
    out["singular_points"] = Json::array();
    for (const intersect::SingularPoint& point : result.singular_points)
      out["singular_points"].push_back(singular_point_json(point));
    out["closed"] = result.closed;
    out["covering"] = result.covering;
  }
  if (result.status == intersect::Status::infinite || !result.overlap.empty()) {
    out["overlap"] = Json::array();
    for (const intersect::Overlap& overlap : result.overlap) out["overlap"].push_back(overlap_json(overlap, shape));
  }
  out["engine"] = engine_json(result.engine);
  if (!result.seconds.empty()) out["seconds"] = seconds_json(result.seconds);
  out["warnings"] = result.warnings;
  return json_layout(out);
}

}  // namespace eliminant::io
