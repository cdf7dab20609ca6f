// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/cli/answer.hpp>
#include <eliminant/cli/arguments.hpp>

namespace eliminant::cli {

/// Reads the problem, solves it and writes the answer; or, where that fails, says why on standard error and, in JSON,
/// in a result with status `error` or `incomplete`. Returns the exit status. Throws io::OutputError.
int run(const Arguments& arguments);

}  // namespace eliminant::cli
