// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measured_runs.hpp"
#include "patch_solvers.hpp"

namespace eliminant::comparisons {

struct MeasuredPatches {
  Ending ending = Ending::failed;
  double milliseconds = 0;  ///< median of the processor time of a run
  FoundPolylines found;
};

/// Runs a solver on one case in a process of its own, which is killed after `limit_seconds` of wall-clock time: once,
/// and four times more where that took less than a fifth of a second. POSIX only.
/// Throws std::runtime_error when no process can be started.
MeasuredPatches measure_patches(PatchRun (*prepare)(const test::PatchCase&), const test::PatchCase& patches,
                                double limit_seconds);

}  // namespace eliminant::comparisons
