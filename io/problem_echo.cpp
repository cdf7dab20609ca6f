// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/problem_echo.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/io/json_layout.hpp>

namespace eliminant::io {

std::string echo_problem(const ProblemFile& file, const RunOptions& options) {
  using Json = nlohmann::ordered_json;
  const intersect::PlaneCurvesProblem& problem = file.problem;
  Json out;
  out["problem"] = "plane_curves";
  if (file.id) std::visit([&](const auto& id) { out["id"] = id; }, *file.id);
  out["variables"] = problem.variables;
  out["p"] = symbolic::to_string(problem.p, problem.variables);
  out["q"] = symbolic::to_string(problem.q, problem.variables);
  if (problem.box) {
    out["box"] = Json::array();
    for (const auto& side : {problem.box->x, problem.box->y})
      out["box"].push_back(Json::array({side[0].to_string(), side[1].to_string()}));
  }
  for (const auto& [name, value, place] : settings_of(options)) {
    if (is_switch(name))
      out["options"][name] = value == "true";
    else
      out["options"][name] = value;
  }
  return json_layout(out);
}

}  // namespace eliminant::io
