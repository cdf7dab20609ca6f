// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/cylinders_json.hpp>

#include <nlohmann/json.hpp>
#include <vector>

#include <eliminant/io/results/cylinders_words.hpp>
#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/result_fields.hpp>
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const std::array<intersect::Coordinate, 3>& vector) {
  Json out = Json::array();
  for (const intersect::Coordinate& coordinate : vector) out.push_back(coordinate_json(coordinate));
  return out;
}

Json solution_json(const intersect::CylinderSolution& solution) {
  Json out;
  out["direction"] = vector_json(solution.direction);
  out["axis_point"] = vector_json(solution.axis_point);
  out["radius_squared"] = coordinate_json(solution.radius_squared);
  out["radius"] = solution.radius ? Json(solution.radius->real) : Json();
  Json error;
  error["direction"] = radius_text(solution.direction_error_exponent);
  error["axis_point"] = radius_text(solution.axis_point_error_exponent);
  error["radius_squared"] = radius_text(solution.radius_squared_error_exponent);
  if (solution.radius) error["radius"] = radius_text(solution.radius_error_exponent);
  out["error"] = std::move(error);
  out["real"] = reality_json(solution.reality);
  out["multiplicity"] = solution.multiplicity;
  out["residual"] = residual_text(solution);
  out["certified"] = solution.certified;
  if (!solution.reason.empty()) out["reason"] = solution.reason;
  return out;
}

}  // namespace

std::string cylinders_json(const intersect::CylindersResult& result, const std::optional<ProblemId>& id) {
  Json out = result_heading(result.problem, id, result.status, result.rest_status, result.limit);
  if (result.degeneracy) out["degeneracy"] = *result.degeneracy;
  if (result.status == intersect::Status::infinite)
    out["directions"] = result.directions ? Json(directions_text(result)) : Json();
  out["counts"] = {{"distinct", result.counts.distinct},
                   {"real", result.counts.real},
                   {"with_multiplicity", result.counts.with_multiplicity},
                   {"isotropic", result.counts.isotropic}};
  out["solutions"] = Json::array();
  for (const intersect::CylinderSolution& solution : result.solutions)
    out["solutions"].push_back(solution_json(solution));
  out["engine"] = engine_json(result.engine);
  out["seconds"] = seconds_json(result.seconds);
  out["warnings"] = result.warnings;
  return json_layout(out);
}

}  // namespace eliminant::io
