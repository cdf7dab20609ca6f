// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// The intersections of a curve with a surface or a curve as JSON, format 1 (docs/formats.md). `id` is the one of the
/// problem.
std::string curve_result_json(const intersect::CurveResult& result, const std::optional<ProblemId>& id);

}  // namespace eliminant::io
