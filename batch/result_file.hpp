// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace eliminant::batch {

/// The output of a batch: one result a line, in order. At every moment the file is a beginning of the finished one, but
/// for a last line that may be torn. Beside the file FILE a second one, FILE.state, says what it belongs to: a heading,
/// then now and then how many results there were, with the hash of the lines they belong to.
class ResultFile {
 public:
  /// Opens `path`, standard input's counterpart for nullopt. A regular file is locked while this object lives. With
  /// `resume` nothing is changed before drop_torn(); else the file is emptied. `description` says what the
  /// results depend on beside the lines. Throws io::OutputError when the file cannot be written or another run has it,
  /// and InvalidInput when it cannot be resumed: it is no regular file, has no state, or belongs to other options.
  ResultFile(std::optional<std::string> path, bool resume, const std::string& description);
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  ~ResultFile();

  /// How many results were there already, and how many of them a limit has ended.
  std::uint64_t kept() const { return kept_; }
  std::uint64_t kept_incomplete() const { return kept_incomplete_; }
  /// Throws InvalidInput when the first `number` lines are not those that the kept results belong to, as far as that is
  /// known.
  void check_kept(std::uint64_t number, std::uint64_t hash) const;
  /// Throws InvalidInput: there are fewer lines than kept results.
  [[noreturn]] void refuse_kept(std::uint64_t lines) const;

  /// Removes the torn end of a file that is continued. To be called once it is known that the kept results belong to
  /// the lines, and before append(). Throws io::OutputError.
  void drop_torn();

  /// Writes results, each with its line's end; with them there are `number`, of lines with this hash. Throws
  /// io::OutputError.
  void append(const std::string& lines, std::uint64_t number, std::uint64_t hash);
  /// Writes what the state is to hold, and waits until everything is on the disk. Throws io::OutputError.
  void finish();

 private:
  void lock();
  void keep_results(const std::string& description);
  std::uint64_t count_results();
  void read_state(const std::string& description);
  void begin_state(const std::string& description);
  void note(std::uint64_t number, std::uint64_t hash);
  void write_all(int file, const std::string& name, const std::string& bytes) const;
  [[noreturn]] void fail(const std::string& name) const;

  std::string name_;
  std::string state_name_;
  int file_ = -1;
  int state_ = -1;
  // What is whole of a file that is continued, and of its state.
  std::optional<std::uint64_t> whole_size_;
  std::uint64_t whole_state_size_ = 0;
  std::uint64_t kept_ = 0;
  std::uint64_t kept_incomplete_ = 0;
  std::map<std::uint64_t, std::uint64_t> noted_;
  std::chrono::steady_clock::time_point last_note_;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> unnoted_;
};

}  // namespace eliminant::batch
