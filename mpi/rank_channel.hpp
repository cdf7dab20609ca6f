// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpi.h>

#include <optional>
#include <string>

#include <eliminant/batch/frame.hpp>

namespace eliminant::mpi {

/// Frames between this rank and another one. Nothing here waits: what cannot be sent yet is kept.
class RankChannel {
 public:
  explicit RankChannel(int rank) : rank_(rank) {}
  RankChannel(const RankChannel&) = delete;
  RankChannel& operator=(const RankChannel&) = delete;

  void send(const batch::Frame& frame);
  /// Sends what can be sent now. What is on its way must have arrived before this object ends: is_idle().
  void flush();
  bool is_idle() const { return !sending_ && unsent_.empty(); }
  /// Reads what has arrived. Returns whether that was anything.
  bool fill();
  std::optional<batch::Frame> receive() { return received_.next(); }

 private:
  int rank_;
  std::string unsent_;
  // What is on its way, unchanged until it has arrived.
  std::string sent_;
  MPI_Request request_ = MPI_REQUEST_NULL;
  bool sending_ = false;
  std::string arrived_;
  batch::FrameAssembly received_;
};

}  // namespace eliminant::mpi
