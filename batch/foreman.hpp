// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/batch/channel.hpp>
#include <eliminant/batch/worker_pool.hpp>

namespace eliminant::batch {

/// Solves the problems that arrive with worker processes of this one, and sends the results back in the order in which
/// they are ready, until the connection ends. Problems that wait behind slow ones are returned. For a process between
/// the workers and one that must not fork.
void serve(Channel& channel, unsigned workers, const Solver& solver);

}  // namespace eliminant::batch
