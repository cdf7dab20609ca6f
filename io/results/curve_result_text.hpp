// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/io/input/run_options.hpp>

namespace eliminant::io {

/// The intersections of a curve with a surface or a curve for people: the status, where they overlap, the count audit
/// (every sum checked again, and named when it fails), what was given and used, then the solutions as a table, or as
/// blocks where the numbers are too long for one. The seconds are left out when `with_seconds` is false, so that equal
/// results are equal texts.
std::string curve_result_text(const intersect::CurveResult& result, const RunOptions& given, bool with_seconds = true);

}  // namespace eliminant::io
