// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include <eliminant/batch/line_hash.hpp>
#include <eliminant/batch/line_reader.hpp>
#include <eliminant/batch/result_file.hpp>
#include <eliminant/batch/worker_pool.hpp>

namespace eliminant::batch {

/// How much may be handed out, or wait for the results before it, at one time. When the first result is late and this
/// is reached, the workers wait for it.
struct Window {
  std::size_t problems = 100'000;
  std::size_t bytes = std::size_t{1} << 27U;
};

/// The problems of a file on their way to the results: handed out in order, taken back in any, written in order.
class BatchJob {
 public:
  /// Skips the problems whose results the output has already. `refused` is the result of a line that is too long.
  /// Throws InvalidInput when the output does not belong to the problems.
  BatchJob(LineReader& lines, ResultFile& output, std::function<std::string(const Task&)> refused, Window window = {});

  /// The next problem; nullopt when there is none now: the window is full, or at the end, or while the input has to be
  /// waited for.
  std::optional<Task> take();
  /// Nobody has begun with it: it will be handed out again.
  void give_back(std::uint64_t number) { given_back_.insert(number); }
  /// Its result. Throws io::OutputError.
  void finish(Outcome outcome);
  /// Writes the results that are next. Throws io::OutputError.
  void write();

  /// Every problem has its result, and all of them are written.
  bool done() const { return lines_.at_end() && slots_.empty(); }
  /// What poll() may have to wait on before there is a problem to take, or -1.
  int awaited() const { return is_full() ? -1 : lines_.awaited(); }

  /// Results in the output, and how many of them have the status error or incomplete, resumed ones included in the
  /// first and the last number.
  std::uint64_t written() const { return first_; }
  std::uint64_t errors() const { return errors_; }
  std::uint64_t incomplete() const { return incomplete_; }
  std::uint64_t resumed() const { return output_.kept(); }

 private:
  // A problem from its being read to its result's being written.
  struct Slot {
    Task task;
    std::uint64_t hash = 0;
    std::optional<std::string> result;
  };
  void skip_kept();
  bool is_full() const;
  void add_slot(LineReader::Line line);

  LineReader& lines_;
  ResultFile& output_;
  std::function<std::string(const Task&)> refused_;
  Window window_;
  LineHash hash_;
  std::deque<Slot> slots_;
  // The number of the first slot.
  std::uint64_t first_ = 0;
  std::set<std::uint64_t> given_back_;
  std::size_t bytes_ = 0;
  std::uint64_t errors_ = 0;
  std::uint64_t incomplete_ = 0;
};

}  // namespace eliminant::batch
