// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/results/surface_result_words.hpp>

namespace eliminant::io {

/// The intersection of two surfaces, or of one with itself, as JSON, format 1 (docs/formats.md). `domains` and `id` are
/// those of the problem; with `equation` the eliminant is written in full.
std::string surface_result_json(const intersect::SurfaceResult& result, const SurfaceDomains& domains,
                                const std::optional<ProblemId>& id, bool equation);

}  // namespace eliminant::io
