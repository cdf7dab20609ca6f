// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// Cylinders through five points as JSON, format 1 (docs/formats.md). `id` is the one of the problem.
std::string cylinders_json(const intersect::CylindersResult& result, const std::optional<ProblemId>& id);

}  // namespace eliminant::io
