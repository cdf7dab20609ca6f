// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

#include <eliminant/base/error.hpp>

namespace eliminant {

/// Progress, cancellation and the time limit of one computation, handed by reference through every stage. Stages call
/// `checkpoint` between units of work (a prime, a precision, a solution); `cancel` may be called from any thread.
class Context {
 public:
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Wall-clock limit counted from this call.
  void limit_seconds(double seconds) {
    deadline_ = std::chrono::steady_clock::now() +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
  }
  void on_progress(std::function<void(std::string_view)> callback) { progress_ = std::move(callback); }
  void cancel() { cancelled_ = true; }

  /// Reports `stage` and throws LimitReached when the limit has passed or `cancel` was called.
  void checkpoint(std::string_view stage) const {
    if (progress_) progress_(stage);
    if (cancelled_) throw LimitReached("cancelled during " + std::string(stage));
    if (deadline_ && std::chrono::steady_clock::now() > *deadline_)
      throw LimitReached("the time limit was reached during " + std::string(stage));
  }

 private:
  std::optional<std::chrono::steady_clock::time_point> deadline_;
  std::function<void(std::string_view)> progress_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace eliminant
