// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <eliminant/intersect/result.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

// The JSON that results of every kind of problem have in common (docs/formats.md).

/// The fields that begin a result: `format`, `problem`, and where they apply `id`; `status`, and where they apply
/// `rest_status` and `error`, which stands for the limit.
nlohmann::ordered_json result_heading(const std::string& problem, const std::optional<ProblemId>& id,
                                      intersect::Status status, const std::optional<intersect::Status>& rest_status,
                                      const std::optional<std::string>& limit);

/// The pair [real, imaginary] of decimal strings.
nlohmann::ordered_json coordinate_json(const intersect::Coordinate& coordinate);

/// true, false, or null while undecided.
nlohmann::ordered_json reality_json(intersect::Reality reality);

/// The field `engine`: only what applies, so that fields left at their defaults are absent.
nlohmann::ordered_json engine_json(const intersect::EngineReport& engine);

/// The field `seconds`: every stage, rounded to microseconds.
nlohmann::ordered_json seconds_json(const std::vector<std::pair<std::string, double>>& seconds);

}  // namespace eliminant::io
