// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/foreman.hpp>

#include <poll.h>

#include <chrono>
#include <deque>
#include <utility>
#include <vector>

namespace eliminant::batch {

namespace {

using Clock = std::chrono::steady_clock;

// How long problems wait here, in milliseconds, before they are returned to be solved elsewhere.
constexpr int longest_wait = 50;

// Problems between their arrival and their start.
class Queue {
 public:
  explicit Queue(Channel& channel) : channel_(channel) {}

  void add(Frame frame) {
    if (tasks_.empty()) last_start_ = Clock::now();
    tasks_.push_back({frame.number, frame.line, std::move(frame.text)});
  }
  void start(WorkerPool& pool) {
    while (!tasks_.empty() && pool.has_idle_worker()) {
      pool.start(std::move(tasks_.front()));
      tasks_.pop_front();
      last_start_ = Clock::now();
    }
  }
  void return_late() {
    if (tasks_.empty() || Clock::now() - last_start_ < std::chrono::milliseconds(longest_wait)) return;
    for (const Task& task : tasks_) channel_.send({Frame::Kind::returned, task.number, task.line, {}});
    tasks_.clear();
  }
  bool empty() const { return tasks_.empty(); }

 private:
  Channel& channel_;
  std::deque<Task> tasks_;
  Clock::time_point last_start_;
};

}  // namespace

void serve(Channel& channel, unsigned workers, const Solver& solver) {
  WorkerPool pool(workers, solver);
  Queue queue(channel);
  while (true) {
    std::vector<pollfd> awaited{{channel.socket(), channel.events(), 0}};
    for (Outcome& outcome : pool.wait(queue.empty() ? -1 : longest_wait, awaited))
      channel.send({Frame::Kind::result, outcome.number, 0, std::move(outcome.result)});
    if ((awaited[0].revents & POLLOUT) != 0) channel.flush();
    if ((awaited[0].revents & ~POLLOUT) != 0 && !channel.fill()) return;
    while (auto frame = channel.receive()) queue.add(std::move(*frame));
    queue.start(pool);
    queue.return_late();
  }
}

}  // namespace eliminant::batch
