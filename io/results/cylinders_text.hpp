// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/io/input/run_options.hpp>

namespace eliminant::io {

/// Cylinders through five points for people: status, count audit, what was given and used, then each cylinder.
std::string cylinders_text(const intersect::CylindersResult& result, const RunOptions& options);

}  // namespace eliminant::io
