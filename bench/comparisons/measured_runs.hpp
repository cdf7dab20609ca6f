// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "solvers.hpp"

namespace eliminant::comparisons {

enum class Ending { finished, out_of_time, failed };

/// What several runs of one solver on one system took. When not one run ended, only `ending` is meaningful.
struct MeasuredRuns {
  Ending ending = Ending::failed;
  int runs = 0;
  double milliseconds = 0;    ///< median of the processor time of a run
  double peak_megabytes = 0;  ///< of the process that did nothing else, with the program itself
  RunOutcome outcome;         ///< of the last run
};

/// Runs what `prepare` gives in a process of its own: at least three times, and for a second where that is more, but no
/// further run once half of `limit_seconds` has passed. The process is killed when it says nothing for `limit_seconds`
/// of wall-clock time; what ended before counts. A solver that throws or crashes has failed.
/// POSIX only. Throws std::runtime_error when no process can be started.
MeasuredRuns measure(const std::function<Run()>& prepare, double limit_seconds);

}  // namespace eliminant::comparisons
