// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/result_fields.hpp>

#include <nlohmann/json.hpp>

#include <cmath>

#include <eliminant/io/results/error_report.hpp>
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

using Json = nlohmann::ordered_json;

Json result_heading(const std::string& problem, const std::optional<ProblemId>& id, intersect::Status status,
                    const std::optional<intersect::Status>& rest_status, const std::optional<std::string>& limit) {
  Json out;
  out["format"] = 1;
  out["problem"] = problem;
  if (id) std::visit([&](const auto& value) { out["id"] = value; }, *id);
  out["status"] = word_for(status);
  if (rest_status) out["rest_status"] = word_for(*rest_status);
  if (limit) out["error"] = error_object(report_error(LimitReached(*limit)));
  return out;
}

Json coordinate_json(const intersect::Coordinate& coordinate) {
  return Json::array({coordinate.real, coordinate.imaginary});
}

Json reality_json(intersect::Reality reality) {
  if (reality == intersect::Reality::undecided) return nullptr;
  return reality == intersect::Reality::real;
}

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
  add("singular_pencil", engine.singular_pencil, !engine.singular_pencil.empty());
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

}  // namespace eliminant::io
