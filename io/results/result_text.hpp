// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/result.hpp>
#include <eliminant/io/input/run_options.hpp>

namespace eliminant::io {

/// The result for people: the status, the count audit (every sum checked again, and named when it fails), what was
/// given and used, then the table of solutions, as blocks where the numbers are too long for a table. The seconds are
/// left out when `with_seconds` is false, so that equal results are equal texts.
std::string result_text(const intersect::Result& result, const RunOptions& given, bool with_seconds = true);

}  // namespace eliminant::io
