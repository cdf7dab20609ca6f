// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/intersect/curve_surface/implicitize.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// A result of `implicitize` as JSON (docs/formats.md).
std::string implicitize_json(const intersect::ImplicitizeResult& result, const std::optional<ProblemId>& id);

}  // namespace eliminant::io
