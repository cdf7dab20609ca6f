// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <poll.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <eliminant/batch/child_process.hpp>

namespace eliminant::batch {

/// A problem of a batch.
struct Task {
  /// Counted from 0 without blank lines.
  std::uint64_t number = 0;
  /// Its line in the file, counted from 1.
  std::uint64_t line = 0;
  std::string text;
};

/// What a worker has made of a problem.
struct Solved {
  /// One line, without its end.
  std::string result;
  /// The memory was exhausted on the way.
  bool memory_exhausted = false;
};

/// What a problem becomes, and what becomes of a problem whose worker died. The first one runs in the workers.
struct Solver {
  std::function<Solved(const Task&)> solve;
  std::function<std::string(const Task&, const Death&)> lost;
};

/// A result on its way to the output.
struct Outcome {
  std::uint64_t number = 0;
  std::string result;
};

/// Processes that solve one problem each at a time. One that dies, or has exhausted its memory, is replaced. Its
/// problem is given to a new process unless it ran out of time: a process that has done nothing else decides, so that
/// the result does not depend on what its worker did before. One that is killed from outside is given three tries.
class WorkerPool {
 public:
  WorkerPool(unsigned count, Solver solver);

  bool has_idle_worker() const;
  /// How many problems have been started and not come back.
  unsigned busy_workers() const;
  /// Gives the problem to an idle worker.
  void start(Task task);
  /// Waits until a worker has something to say, something else happens to `others`, or the time is over; -1 is for
  /// ever. A signal ends it, too. Throws Error when workers keep dying without a problem.
  std::vector<Outcome> wait(int milliseconds, std::vector<pollfd>& others);

 private:
  struct Worker {
    std::unique_ptr<ChildProcess> process;
    std::unique_ptr<Task> task;
    unsigned solved = 0;
    unsigned tries = 0;
  };
  void replace_process(Worker& worker);
  void solve_until_the_end(Channel& channel) const;
  void give(Worker& worker);
  void collect(Worker& worker, short happened, std::vector<Outcome>& outcomes);
  void finish(Worker& worker, std::string result, std::vector<Outcome>& outcomes);

  Solver solver_;
  std::vector<Worker> workers_;
  // Workers that died one after the other without having solved anything.
  unsigned idle_deaths_ = 0;
};

}  // namespace eliminant::batch
