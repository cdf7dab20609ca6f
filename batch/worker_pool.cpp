// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/worker_pool.hpp>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include <eliminant/base/error.hpp>

namespace eliminant::batch {

namespace {

// How often a problem is given to a process that is killed by somebody else: the third time it is the problem's own
// doing, such as more memory than the machine has.
constexpr unsigned most_tries = 3;
constexpr unsigned most_idle_deaths = 1000;

bool is_from_outside(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP || signal == SIGQUIT;
}

}  // namespace

WorkerPool::WorkerPool(unsigned count, Solver solver) : solver_(std::move(solver)), workers_(count) {
  for (Worker& worker : workers_) replace_process(worker);
}

void WorkerPool::replace_process(Worker& worker) {
  worker.process.reset();
  worker.solved = 0;
  // A child that held the connections of the others would keep them open when this process ends.
  const auto close_others = [this] {
    for (const Worker& other : workers_)
      if (other.process) close(other.process->channel().socket());
  };
  worker.process =
      std::make_unique<ChildProcess>(close_others, [this](Channel& channel) { solve_until_the_end(channel); });
}

void WorkerPool::solve_until_the_end(Channel& channel) const {
  while (auto frame = channel.wait_for_frame()) {
    const Solved solved = solver_.solve({frame->number, frame->line, std::move(frame->text)});
    const Frame::Kind kind = solved.memory_exhausted ? Frame::Kind::exhausted : Frame::Kind::result;
    if (!channel.send_all({kind, frame->number, frame->line, solved.result})) return;
  }
}

bool WorkerPool::has_idle_worker() const {
  return std::any_of(workers_.begin(), workers_.end(), [](const Worker& worker) { return !worker.task; });
}

unsigned WorkerPool::busy_workers() const {
  return static_cast<unsigned>(
      std::count_if(workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.task != nullptr; }));
}

void WorkerPool::start(Task task) {
  const auto idle = std::find_if(workers_.begin(), workers_.end(), [](const Worker& worker) { return !worker.task; });
  idle->task = std::make_unique<Task>(std::move(task));
  idle->tries = 0;
  give(*idle);
}

void WorkerPool::give(Worker& worker) {
  ++worker.tries;
  worker.process->channel().send({Frame::Kind::task, worker.task->number, worker.task->line, worker.task->text});
}

std::vector<Outcome> WorkerPool::wait(int milliseconds, std::vector<pollfd>& others) {
  std::vector<pollfd> entries;
  for (const Worker& worker : workers_) {
    Channel& channel = worker.process->channel();
    entries.push_back({channel.socket(), channel.events(), 0});
  }
  entries.insert(entries.end(), others.begin(), others.end());
  std::vector<Outcome> outcomes;
  if (poll(entries.data(), entries.size(), milliseconds) <= 0) {
    for (pollfd& other : others) other.revents = 0;
    return outcomes;
  }
  for (std::size_t i = 0; i < workers_.size(); ++i)
    if (entries[i].revents != 0) collect(workers_[i], entries[i].revents, outcomes);
  std::copy(entries.begin() + static_cast<std::ptrdiff_t>(workers_.size()), entries.end(), others.begin());
  return outcomes;
}

void WorkerPool::collect(Worker& worker, short happened, std::vector<Outcome>& outcomes) {
  Channel& channel = worker.process->channel();
  if ((happened & POLLOUT) != 0) channel.flush();
  if ((happened & ~POLLOUT) == 0) return;
  const bool alive = channel.fill();
  if (auto frame = channel.receive(); frame && worker.task) {
    const bool fresh = worker.solved == 0;
    ++worker.solved;
    const bool exhausted = frame->kind == Frame::Kind::exhausted;
    if (exhausted) replace_process(worker);
    if (exhausted && !fresh)
      give(worker);
    else
      finish(worker, std::move(frame->text), outcomes);
    if (exhausted) return;
  }
  if (alive) return;
  const bool fresh = worker.solved == 0;
  const Death death = worker.process->wait_for_death();
  if (!worker.task && ++idle_deaths_ > most_idle_deaths)
    throw Error("the worker processes end " + in_words(death) + " before they are given a problem");
  replace_process(worker);
  if (!worker.task) return;
  const bool again = death.signal != SIGALRM && (is_from_outside(death.signal) ? worker.tries < most_tries : !fresh);
  if (again)
    give(worker);
  else
    finish(worker, solver_.lost(*worker.task, death), outcomes);
}

void WorkerPool::finish(Worker& worker, std::string result, std::vector<Outcome>& outcomes) {
  idle_deaths_ = 0;
  outcomes.push_back({worker.task->number, std::move(result)});
  worker.task.reset();
}

}  // namespace eliminant::batch
