// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/mpi/hand_out.hpp>

#include <algorithm>

namespace eliminant::mpi {

namespace {

// Seconds of work, and number of problems, that a rank has in advance. Ranks look at their messages every millisecond.
constexpr double advance_seconds = 0.02;
constexpr double most_in_advance = 256;
// Of the newest interval in the mean.
constexpr double weight = 0.1;

}  // namespace

void HandOut::give() {
  // The time without any problem tells nothing about the problems.
  if (in_flight_ == 0) last_ = Clock::now();
  ++in_flight_;
}

void HandOut::take_result() {
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - last_).count();
  interval_ = interval_ == 0 ? elapsed : (1 - weight) * interval_ + weight * elapsed;
  last_ = now;
  in_flight_ -= std::min<std::size_t>(in_flight_, 1);
  const double advance = std::min(most_in_advance, advance_seconds / std::max(interval_, 1e-6));
  most_ = workers_ + static_cast<std::size_t>(advance);
}

void HandOut::take_back() {
  in_flight_ -= std::min<std::size_t>(in_flight_, 1);
  most_ = workers_;
  interval_ = std::max(interval_, advance_seconds);
}

}  // namespace eliminant::mpi
