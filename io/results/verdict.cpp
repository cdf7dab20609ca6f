// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/verdict.hpp>

#include <nlohmann/json.hpp>

#include <eliminant/io/results/json_layout.hpp>
#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

namespace {

using Json = nlohmann::ordered_json;

Json verdict_json(const std::string& of, const std::vector<std::string>& reasons, const std::optional<ProblemId>& id) {
  Json out;
  out["format"] = 1;
  out["verify"] = of;
  if (id) std::visit([&](const auto& value) { out["id"] = value; }, *id);
  out["verdict"] = reasons.empty() ? "accepted" : "refused";
  out["reasons"] = reasons;
  return out;
}

std::string verdict_text(const std::vector<std::string>& reasons) {
  std::string text = reasons.empty() ? "Verdict: accepted\n" : "Verdict: refused\n";
  for (const std::string& reason : reasons) text += "  " + reason + "\n";
  return text;
}

Json solution_json(const intersect::Solution& solution) {
  Json out;
  out["x"] = Json::array({solution.x.real, solution.x.imaginary});
  out["y"] = Json::array({solution.y.real, solution.y.imaginary});
  return out;
}

Json distance_json(const intersect::CandidateDistance& found, const intersect::CandidateReport& report) {
  Json out;
  out["candidate"] = found.candidate;
  if (!found.solution) return out;
  out["solution"] = solution_json(report.truth.solutions[*found.solution]);
  out["distance"] = found.distance;
  return out;
}

std::string candidates_json(const intersect::CandidateReport& report, const std::optional<ProblemId>& id) {
  Json out = verdict_json("candidates", report.reasons, id);
  out["status"] = word_for(report.truth.status);
  if (report.truth.rest_status) out["rest_status"] = word_for(*report.truth.rest_status);
  const std::vector<intersect::Solution>& solutions = report.truth.solutions;
  out["matched"] = Json::array();
  for (const auto& found : report.matched) out["matched"].push_back(distance_json(found, report));
  out["spurious"] = Json::array();
  for (const auto& found : report.spurious) {
    Json entry = distance_json(found, report);
    if (entry.contains("solution")) {
      entry["nearest"] = entry["solution"];
      entry.erase("solution");
    }
    out["spurious"].push_back(entry);
  }
  if (report.truth.common_component) {
    out["common_component"] = symbolic::to_string(*report.truth.common_component, report.truth.variables);
    out["on_component"] = report.on_component;
  }
  out["missing"] = Json::array();
  for (const std::size_t k : report.missing) {
    Json entry = solution_json(solutions[k]);
    entry["multiplicity"] = solutions[k].multiplicity;
    out["missing"].push_back(entry);
  }
  out["multiplicity_errors"] = Json::array();
  for (const auto& error : report.multiplicity_errors) {
    Json entry;
    entry["candidates"] = error.candidates;
    entry["solution"] = solution_json(solutions[error.solution]);
    entry["claimed"] = error.claimed;
    entry["expected"] = error.expected;
    out["multiplicity_errors"].push_back(entry);
  }
  return json_layout(out);
}

std::string complex_text(const intersect::Coordinate& z) {
  if (z.imaginary == "0") return z.real;
  const bool negative = z.imaginary.front() == '-';
  return z.real + (negative ? " - " : " + ") + z.imaginary.substr(negative ? 1 : 0) + " i";
}

std::string point_text(const intersect::Solution& solution) {
  return "(" + complex_text(solution.x) + ", " + complex_text(solution.y) + ")";
}

std::string candidates_text(const intersect::CandidateReport& report) {
  const std::vector<intersect::Solution>& solutions = report.truth.solutions;
  std::string text = verdict_text(report.reasons);
  text += "\nMatched: " + std::to_string(report.matched.size()) + "\n";
  for (const auto& found : report.matched)
    text += "  candidate " + std::to_string(found.candidate + 1) + " is within " + found.distance + " of " +
            point_text(solutions[*found.solution]) + "\n";
  const auto heading = [&](const char* name, std::size_t count) {
    if (count > 0) text += std::string("\n") + name + ": " + std::to_string(count) + "\n";
    return count > 0;
  };
  if (heading("Spurious", report.spurious.size()))
    for (const auto& found : report.spurious)
      text += "  candidate " + std::to_string(found.candidate + 1) +
              (found.solution ? ": the nearest solution " + point_text(solutions[*found.solution]) + " is " +
                                    found.distance + " away\n"
                              : ": there is no solution\n");
  if (heading("On the common component", report.on_component.size()))
    for (const std::size_t i : report.on_component) text += "  candidate " + std::to_string(i + 1) + "\n";
  if (heading("Missing", report.missing.size()))
    for (const std::size_t k : report.missing)
      text += "  " + point_text(solutions[k]) + ", multiplicity " + std::to_string(solutions[k].multiplicity) + "\n";
  if (heading("Wrong multiplicities", report.multiplicity_errors.size()))
    for (const auto& error : report.multiplicity_errors) {
      text += "  " + point_text(solutions[error.solution]) + " has " + std::to_string(error.expected) +
              ", claimed: " + std::to_string(error.claimed) + " by candidate";
      for (const std::size_t i : error.candidates) text += " " + std::to_string(i + 1);
      text += "\n";
    }
  return text;
}

}  // namespace

std::string certificate_verdict(const std::vector<std::string>& reasons, const std::optional<ProblemId>& id,
                                Format format) {
  return format == Format::json ? json_layout(verdict_json("certificate", reasons, id)) : verdict_text(reasons);
}

std::string candidates_verdict(const intersect::CandidateReport& report, const std::optional<ProblemId>& id,
                               Format format) {
  return format == Format::json ? candidates_json(report, id) : candidates_text(report);
}

}  // namespace eliminant::io
