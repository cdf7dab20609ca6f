// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/intersect/result.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// The result as JSON, format 1 (docs/formats.md). `id` is the one of the problem.
std::string result_json(const intersect::Result& result, const std::optional<ProblemId>& id);

}  // namespace eliminant::io
