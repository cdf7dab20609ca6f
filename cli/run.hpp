// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include <eliminant/cli/answer.hpp>
#include <eliminant/cli/arguments.hpp>

namespace eliminant::cli {

/// Reads the problem, solves it and writes the answer; or, where that fails, says why on standard error and, in JSON,
/// in a result with status `error` or `incomplete`. Returns the exit status. Throws io::OutputError.
int run(const Arguments& arguments);

/// A line of a batch, counted from 1 in its file.
struct BatchLine {
  std::size_t number = 0;
  std::string text;
};

struct LineResult {
  std::string json;
  /// This process should not be given another problem.
  bool memory_exhausted = false;
};

/// The same for a problem of a batch, with the settings of `arguments`: the result as one line of JSON, also where it
/// is an error, whose place is in the file. One thread, no message; what depends on the machine only with `timings`.
/// Limits hold for this problem alone; beyond the time limit of a call that does not come back SIGALRM ends the
/// process. Throws std::bad_alloc only when there is no memory for the result of an error.
LineResult result_line(const BatchLine& line, const Arguments& arguments);

}  // namespace eliminant::cli
