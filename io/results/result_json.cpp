// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/result_json.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/result_fields.hpp>
#include <eliminant/io/results/result_words.hpp>

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
  out["x"] = coordinate_json(solution.x);
  out["y"] = coordinate_json(solution.y);
  out["radius"] = radius_text(solution.radius_exponent);
  out["real"] = reality_json(solution.reality);
  out["multiplicity"] = solution.multiplicity;
  out["certified"] = solution.certified;
  if (!solution.certified && !solution.reason.empty()) out["reason"] = solution.reason;
  return out;
}

}  // namespace

std::string result_json(const intersect::Result& result, const std::optional<ProblemId>& id) {
  Json out = result_heading(result.problem, id, result.status, result.rest_status, result.limit);
  out["variables"] = result.variables;
  if (result.common_component)
    out["common_component"] = symbolic::to_string(*result.common_component, result.variables);
  out["counts"] = counts_json(result.counts);
  out["solutions"] = Json::array();
  for (const intersect::Solution& solution : result.solutions) out["solutions"].push_back(solution_json(solution));
  out["engine"] = engine_json(result.engine);
  if (!result.seconds.empty()) out["seconds"] = seconds_json(result.seconds);
  out["warnings"] = result.warnings;
  return json_layout(out);
}

}  // namespace eliminant::io
