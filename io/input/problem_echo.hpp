// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/io/input/problem_file.hpp>

namespace eliminant::io {

/// The problem as understood, as a problem file in JSON: reading it gives the same problem, id and options.
std::string echo_problem(const ProblemFile& file, const RunOptions& options);

}  // namespace eliminant::io
