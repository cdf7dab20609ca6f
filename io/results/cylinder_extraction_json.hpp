// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// The result as JSON (docs/formats.md), numbers with `digits` significant digits. Labels of points are not in it.
std::string cylinder_extraction_json(const intersect::CylinderExtractionResult& result,
                                     const std::optional<ProblemId>& id, long digits);

}  // namespace eliminant::io
