// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/result_json.hpp>

#include <nlohmann/json.hpp>

#include <cmath>

#include <eliminant/io/error_report.hpp>
#include <eliminant/io/json_layout.hpp>
#include <eliminant/io/result_words.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;

Json counts_json(const intersect::Counts& counts) {
  return {{"distinct", counts.distinct},
          {"real", counts.real},
          {"undecided", counts.undecided},
          {"with_multiplicity", counts.with_multiplicity},
          {"at_infinity", counts.at_infinity},
          {"bezout_number", counts.bezout_number},
          {"listed", counts.listed}};
}

Json solution_json(const intersect::Solution& solution) {
  Json out;
  out["x"] = Json::array({solution.x.real, solution.x.imaginary});
  out["y"] = Json::array({solution.y.real, solution.y.imaginary});
  out["radius"] = "1e" + std::to_string(solution.radius_exponent);
  if (solution.reality == intersect::Reality::undecided)
    out["real"] = nullptr;
  else
    out["real"] = solution.reality == intersect::Reality::real;
  out["multiplicity"] = solution.multiplicity;
  out["certified"] = solution.certified;
  if (!solution.certified && !solution.reason.empty()) out["reason"] = solution.reason;
  return out;
}

// Only what applies: the fields left at their defaults are absent.
Json engine_json(const intersect::EngineReport& engine) {
  Json out = Json::object();
  const auto add = [&](const char* name, const auto& value, bool applies) {
    if (applies) out[name] = value;
  };
  add("method", engine.method, !engine.method.empty());
  add("matrix", engine.matrix, !engine.matrix.empty());
  add("hidden_variable", engine.hidden_variable, !engine.hidden_variable.empty());
  add("matrix_size", engine.matrix_size, engine.matrix_size != 0);
  add("matrix_degree", engine.matrix_degree, engine.matrix_size != 0);
  add("pencil_size", engine.pencil_size, engine.pencil_size != 0);
  add("regular_size", engine.regular_size, engine.pencil_size != 0);
  add("precision_bits", engine.precision_bits, engine.precision_bits != 0);
  if (engine.shear) out["shear"] = *engine.shear;
  if (engine.largest_error_before_refinement)
    out["largest_error_before_refinement"] = *engine.largest_error_before_refinement;
  if (engine.pencil_multiplicities)
    out["pencil_multiplicities"] = {{"distinct", engine.pencil_multiplicities->distinct_by_multiplicity},
                                    {"at_infinity", engine.pencil_multiplicities->at_infinity}};
  out["seed"] = engine.seed;
  return out;
}

Json seconds_json(const std::vector<std::pair<std::string, double>>& seconds) {
  Json out = Json::object();
  for (const auto& [stage, value] : seconds) out[stage] = std::round(value * 1e6) / 1e6;
  return out;
}

}  // namespace

std::string result_json(const intersect::Result& result, const std::optional<ProblemId>& id) {
  Json out;
  out["format"] = 1;
  out["problem"] = result.problem;
  if (id) std::visit([&](const auto& value) { out["id"] = value; }, *id);
  out["status"] = word_for(result.status);
  if (result.rest_status) out["rest_status"] = word_for(*result.rest_status);
  if (result.limit) out["error"] = error_object(report_error(LimitReached(*result.limit)));
  out["variables"] = result.variables;
  if (result.common_component)
    out["common_component"] = symbolic::to_string(*result.common_component, result.variables);
  out["counts"] = counts_json(result.counts);
  out["solutions"] = Json::array();
  for (const intersect::Solution& solution : result.solutions) out["solutions"].push_back(solution_json(solution));
  out["engine"] = engine_json(result.engine);
  out["seconds"] = seconds_json(result.seconds);
  out["warnings"] = result.warnings;
  return json_layout(out);
}

}  // namespace eliminant::io
