// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>

namespace eliminant::mpi {

/// How many problems one rank is to have at a time: as many as keep it busy for a moment, so that it does not wait for
/// the next message, and no more, so that none waits behind a slow one while other ranks have nothing to do.
class HandOut {
 public:
  explicit HandOut(unsigned workers) : workers_(workers), most_(workers) {}

  bool has_room() const { return in_flight_ < most_; }
  void give();
  /// A result came back.
  void take_result();
  /// A problem came back that nobody has begun with: what is there now is slow.
  void take_back();

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t workers_;
  std::size_t most_;
  std::size_t in_flight_ = 0;
  // Mean seconds between two results, the last ones counting most.
  double interval_ = 0;
  Clock::time_point last_ = Clock::now();
};

}  // namespace eliminant::mpi
