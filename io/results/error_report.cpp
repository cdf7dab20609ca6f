// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/error_report.hpp>

#include <nlohmann/json.hpp>

#include <new>

#include <eliminant/io/results/json_layout.hpp>

namespace eliminant::io {

ErrorReport report_error(const std::exception& error) {
  if (const auto* parse = dynamic_cast<const ParseError*>(&error))
    return {"parse_error", 2, parse->what(), parse->expected(), parse->place()};
  if (const auto* invalid = dynamic_cast<const InvalidInput*>(&error))
    return {"invalid_input", 2, invalid->what(), invalid->expected(), invalid->place()};
  if (const auto* limit = dynamic_cast<const LimitReached*>(&error))
    return {"limit", 3, limit->what(), {}, limit->place()};
  if (dynamic_cast<const PrecisionExhausted*>(&error) != nullptr) return {"precision", 3, error.what(), {}, {}};
  if (is_exhausted_memory(error)) return {"limit", 3, "the memory is exhausted", {}, {}};
  if (dynamic_cast<const OutputError*>(&error) != nullptr) return {"output", 1, error.what(), {}, {}};
  return {"internal", 1, error.what(), {}, {}};
}

bool is_exhausted_memory(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
         dynamic_cast<const std::length_error*>(&error) != nullptr;
}

std::string error_line(const ErrorReport& report, const std::string& source) {
  std::string line = source;
  if (report.place.line != 0)
    line += ":" + std::to_string(report.place.line) + ":" + std::to_string(report.place.column);
  line += (line.empty() ? "" : ": ") + report.message;
  if (!report.expected.empty()) line += "; expected " + report.expected;
  return line;
}

nlohmann::ordered_json error_object(const ErrorReport& report) {
  nlohmann::ordered_json error;
  error["kind"] = report.kind;
  error["message"] = report.message;
  const bool placed = report.place.line != 0;
  error["line"] = placed ? nlohmann::ordered_json(report.place.line) : nullptr;
  error["column"] = report.place.column != 0 ? nlohmann::ordered_json(report.place.column) : nullptr;
  error["expected"] = report.expected.empty() ? nullptr : nlohmann::ordered_json(report.expected);
  return error;
}

std::string error_json(const ErrorReport& report, const std::optional<std::string>& problem,
                       const std::optional<ProblemId>& id, bool incomplete) {
  nlohmann::ordered_json out;
  out["format"] = 1;
  out["problem"] = problem ? nlohmann::ordered_json(*problem) : nullptr;
  if (id) std::visit([&](const auto& value) { out["id"] = value; }, *id);
  out["status"] = incomplete ? "incomplete" : "error";
  out["error"] = error_object(report);
  if (incomplete) out["solutions"] = nlohmann::ordered_json::array();
  return json_layout(out);
}

}  // namespace eliminant::io
