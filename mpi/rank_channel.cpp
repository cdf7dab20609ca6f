// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/mpi/rank_channel.hpp>

#include <algorithm>

namespace eliminant::mpi {

namespace {

constexpr int frame_tag = 1;
// Longer messages are cut: MPI counts with int.
constexpr std::size_t longest_message = std::size_t{1} << 24U;

}  // namespace

void RankChannel::send(const batch::Frame& frame) { append_frame(frame, unsent_); }

void RankChannel::flush() {
  if (sending_) {
    int arrived = 0;
    MPI_Test(&request_, &arrived, MPI_STATUS_IGNORE);
    sending_ = arrived == 0;
  }
  if (sending_ || unsent_.empty()) return;
  const std::size_t size = std::min(unsent_.size(), longest_message);
  sent_ = unsent_.substr(0, size);
  unsent_.erase(0, size);
  MPI_Isend(sent_.data(), static_cast<int>(size), MPI_BYTE, rank_, frame_tag, MPI_COMM_WORLD, &request_);
  sending_ = true;
}

bool RankChannel::fill() {
  bool any = false;
  while (true) {
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(rank_, frame_tag, MPI_COMM_WORLD, &there, &status);
    if (there == 0) return any;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    arrived_.resize(static_cast<std::size_t>(size));
    MPI_Recv(arrived_.data(), size, MPI_BYTE, rank_, frame_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    received_.add(arrived_.data(), arrived_.size());
    any = true;
  }
}

}  // namespace eliminant::mpi
