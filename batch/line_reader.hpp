// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace eliminant::batch {

/// The part I of N of a file, I from 1 to N.
struct Shard {
  std::uint64_t index = 1;
  std::uint64_t count = 1;
};

/// "I/N". Throws InvalidInput for anything else.
Shard parse_shard(const std::string& text);

/// Lines of a file that may be larger than the memory, or of a pipe, without blank ones.
class LineReader {
 public:
  struct Line {
    /// Counted from 1 in the whole file, blank lines included.
    std::uint64_t line = 0;
    std::string text;
    /// It is longer than longest_line; `text` is its beginning.
    bool too_long = false;
  };
  static constexpr std::size_t longest_line = std::size_t{1} << 26U;

  /// Opens `path`, "-" is standard input. With a shard, that part: the file is cut at the multiples of its size / N,
  /// and a line belongs to the part in which it begins, so that the results of all parts one after the other are those
  /// of the whole. Throws InvalidInput for what cannot be read, and for a shard of what is no regular file.
  LineReader(const std::string& path, const std::optional<Shard>& shard);
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  ~LineReader();

  /// The next line; nullopt at the end, and while it would have to be waited for.
  std::optional<Line> next();
  bool at_end() const { return at_end_; }
  /// What poll() can wait on for more, or -1 for a file, which never has to be waited for.
  int awaited() const { return at_end_ || regular_ ? -1 : file_; }

 private:
  void find_shard(const Shard& shard, std::uint64_t size);
  bool read_block();
  // The line that ends at `end` in the block, or at the end of the file; nullopt when it is blank or of another part.
  std::optional<Line> finish_line(std::size_t end);

  std::string name_;
  int file_ = -1;
  bool regular_ = false;
  bool at_end_ = false;
  std::string block_;
  std::size_t taken_ = 0;
  std::string begun_;
  bool too_long_ = false;
  std::uint64_t line_ = 1;
  // Where the line begins in the file, and where lines of this part may begin.
  std::uint64_t line_offset_ = 0;
  std::uint64_t offset_ = 0;
  std::uint64_t first_offset_ = 0;
  std::optional<std::uint64_t> end_offset_;
};

}  // namespace eliminant::batch
