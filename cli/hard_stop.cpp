// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/cli/hard_stop.hpp>

#include <algorithm>
#include <chrono>

namespace eliminant::cli {

HardStop::HardStop(double seconds, std::function<void()> stop) {
  // A limit of years is none, and must not overflow the clock.
  const std::chrono::duration<double> delay(std::min(seconds, 1e8));
  thread_ = std::thread([this, delay, stop = std::move(stop)] {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, delay, [this] { return finished_; })) stop();
  });
}

HardStop::~HardStop() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

}  // namespace eliminant::cli
