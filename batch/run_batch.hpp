// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include <eliminant/batch/batch_job.hpp>
#include <eliminant/batch/line_reader.hpp>
#include <eliminant/batch/worker_pool.hpp>

namespace eliminant::batch {

/// What is solved, where the results go, and how it is done.
struct BatchSettings {
  /// A path, or "-" for standard input.
  std::string input;
  /// Standard output for nullopt.
  std::optional<std::string> output;
  std::optional<Shard> shard;
  bool resume = false;
  /// What the results depend on beside the lines: the state of the output holds it (result_file.hpp).
  std::string description;
  /// Worker processes; with MPI those of each rank.
  unsigned workers = 1;
  bool progress = false;
  bool quiet = false;
};

/// Lines on standard error about a batch.
class BatchReport {
 public:
  explicit BatchReport(const BatchSettings& settings) : settings_(settings) {}
  void begin(const BatchJob& job) const;
  /// Now and then how far it is, where the settings ask for it.
  void update(const BatchJob& job);
  /// How it ended. Returns the exit status: 3 when it was interrupted, or a limit ended a problem.
  int end(const BatchJob& job, bool interrupted) const;

 private:
  void say_progress(const BatchJob& job) const;

  const BatchSettings& settings_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = begin_;
};

/// The result of a line that is no problem as it is longer than LineReader::longest_line.
std::string too_long_result(const Task& task);

/// The result of a problem whose worker ended: status incomplete after SIGALRM, which is the time limit, and after
/// SIGABRT where memory was limited, else an error of the kind crash. `problem` and `id` are repeated where the text
/// says them.
std::string lost_result(const Task& task, const Death& death, bool memory_limited = false);

/// Solves every line with worker processes of this one. Returns the exit status. Throws InvalidInput and
/// io::OutputError. To be called while no other thread runs.
int run_batch(const BatchSettings& settings, const Solver& solver);

}  // namespace eliminant::batch
