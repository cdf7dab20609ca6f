// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace eliminant::cli {

/// Runs `stop` in a thread of its own when it has not been destroyed after some seconds: the time limit of stages that
/// do not look at the clock. `stop` should end the process.
class HardStop {
 public:
  HardStop(double seconds, std::function<void()> stop);
  HardStop(const HardStop&) = delete;
  HardStop& operator=(const HardStop&) = delete;
  ~HardStop();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool finished_ = false;
  std::thread thread_;
};

}  // namespace eliminant::cli
