// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/batch/child_process.hpp>
#include <eliminant/batch/run_batch.hpp>

namespace eliminant::mpi {

/// The part of rank 0: reads the problems, hands them out to all ranks, itself included, and writes the results in
/// order. `own` is the process that solves for this rank (batch::serve). Returns the exit status. Throws InvalidInput
/// and io::OutputError; the other ranks end in any case.
int hand_out_batch(const batch::BatchSettings& settings, batch::ChildProcess& own, int ranks);

/// The part of the other ranks: passes on what comes from rank 0 and what `own` answers, until rank 0 has no more.
/// Throws Error when that process ends.
void relay_batch(batch::ChildProcess& own);

}  // namespace eliminant::mpi
