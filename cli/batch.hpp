// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include <eliminant/batch/run_batch.hpp>
#include <eliminant/cli/arguments.hpp>

namespace eliminant::cli {

/// What `arguments` ask for, in the words of batch/. Throws InvalidInput for an option out of range.
batch::BatchSettings batch_settings(const Arguments& arguments);

/// result_line with the settings of `arguments`, which must outlive it.
batch::Solver batch_solver(const Arguments& arguments);

/// Solves the problems of a file, one a line. Returns the exit status. Throws io::OutputError.
int solve_batch(const Arguments& arguments);

/// Runs `solve`; what is thrown besides io::OutputError it says on standard error. Returns the exit status.
int with_reported_errors(const std::string& source, const std::function<int()>& solve);

}  // namespace eliminant::cli
