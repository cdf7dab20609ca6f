// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/mpi/distributed_batch.hpp>

#include <poll.h>

#include <deque>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/batch/interruption.hpp>
#include <eliminant/mpi/hand_out.hpp>
#include <eliminant/mpi/rank_channel.hpp>

namespace eliminant::mpi {

namespace {

using batch::BatchJob;
using batch::Channel;
using batch::Frame;

// How long a rank sleeps, in milliseconds, before it looks at its messages again: MPI itself would wait by spinning,
// and take the processor from the solving process.
constexpr int nap = 1;

void wait_for(const Channel& channel, int input) {
  pollfd entries[2] = {{channel.socket(), channel.events(), 0}, {input, POLLIN, 0}};
  poll(entries, input < 0 ? 1 : 2, nap);
}

void exchange(Channel& channel) {
  channel.flush();
  if (!channel.fill()) throw Error("the process that solves for this rank has ended");
}

void exchange(RankChannel& channel) {
  channel.flush();
  channel.fill();
}

Frame frame_of(batch::Task task) { return {Frame::Kind::task, task.number, task.line, std::move(task.text)}; }

template <class AnyChannel>
void give(BatchJob& job, AnyChannel& channel, HandOut& hand_out) {
  while (hand_out.has_room()) {
    auto task = job.take();
    if (!task) return;
    channel.send(frame_of(std::move(*task)));
    hand_out.give();
  }
}

template <class AnyChannel>
void take(BatchJob& job, AnyChannel& channel, HandOut& hand_out) {
  exchange(channel);
  while (auto frame = channel.receive()) {
    if (frame->kind == Frame::Kind::returned) {
      hand_out.take_back();
      job.give_back(frame->number);
    } else {
      hand_out.take_result();
      job.finish({frame->number, std::move(frame->text)});
    }
  }
}

bool has_finished(RankChannel& channel) {
  exchange(channel);
  while (auto frame = channel.receive())
    if (frame->kind == Frame::Kind::finish) return true;
  return false;
}

// The other ranks, as rank 0 sees them. They end with it.
class OtherRanks {
 public:
  OtherRanks(int ranks, unsigned workers) {
    for (int rank = 1; rank < ranks; ++rank) {
      channels_.emplace_back(rank);
      hand_outs_.emplace_back(workers);
    }
  }
  OtherRanks(const OtherRanks&) = delete;
  OtherRanks& operator=(const OtherRanks&) = delete;
  ~OtherRanks() {
    for (RankChannel& channel : channels_) channel.send({Frame::Kind::finish, 0, 0, {}});
    // A rank that is late still sends results, which nobody needs, before it says the same.
    for (RankChannel& channel : channels_) {
      while (!has_finished(channel)) poll(nullptr, 0, nap);
    }
  }

  void give(BatchJob& job) {
    for (std::size_t i = 0; i < channels_.size(); ++i) mpi::give(job, channels_[i], hand_outs_[i]);
  }
  void take(BatchJob& job) {
    for (std::size_t i = 0; i < channels_.size(); ++i) mpi::take(job, channels_[i], hand_outs_[i]);
  }

 private:
  std::deque<RankChannel> channels_;
  std::deque<HandOut> hand_outs_;
};

}  // namespace

int hand_out_batch(const batch::BatchSettings& settings, batch::ChildProcess& own, int ranks) {
  OtherRanks others(ranks, settings.workers);
  const batch::Interruption interruption;
  batch::LineReader lines(settings.input, settings.shard);
  batch::ResultFile output(settings.output, settings.resume, settings.description);
  BatchJob job(lines, output, batch::too_long_result);
  batch::BatchReport report(settings);
  report.begin(job);
  HandOut own_hand_out(settings.workers);
  while (!interruption.requested()) {
    // The ranks in turn: none is to take all that there is.
    give(job, own.channel(), own_hand_out);
    others.give(job);
    job.write();
    if (job.done()) break;
    wait_for(own.channel(), job.awaited());
    take(job, own.channel(), own_hand_out);
    others.take(job);
    job.write();
    report.update(job);
  }
  const bool interrupted = !job.done();
  output.finish();
  return report.end(job, interrupted);
}

void relay_batch(batch::ChildProcess& own) {
  RankChannel rank_0(0);
  Channel& worker = own.channel();
  while (true) {
    exchange(rank_0);
    while (auto frame = rank_0.receive()) {
      if (frame->kind == Frame::Kind::finish) {
        rank_0.send({Frame::Kind::finish, 0, 0, {}});
        while (!rank_0.is_idle()) {
          rank_0.flush();
          poll(nullptr, 0, nap);
        }
        return;
      }
      worker.send(*frame);
    }
    exchange(worker);
    while (auto frame = worker.receive()) rank_0.send(*frame);
    rank_0.flush();
    wait_for(worker, -1);
  }
}

}  // namespace eliminant::mpi
