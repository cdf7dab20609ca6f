// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/line_reader.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <utility>

#include <eliminant/base/error.hpp>

namespace eliminant::batch {

namespace {

constexpr std::size_t block_size = std::size_t{1} << 18U;
constexpr const char* blanks = " \t\r\n\v\f";

std::uint64_t whole_number(std::string_view text, bool& valid) {
  std::uint64_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  valid = valid && error == std::errc{} && rest == text.data() + text.size();
  return value;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  bool valid = slash < text.size();
  const std::uint64_t index = whole_number(text.substr(0, slash), valid);
  const std::uint64_t count = whole_number(valid ? text.substr(slash + 1) : std::string(), valid);
  if (!valid || index < 1 || count < index || count > 1'000'000)
    throw InvalidInput("option shard is '" + text.substr(0, 40) + "'",
                       "I/N, two whole numbers with 1 <= I <= N <= 1000000");
  return {index, count};
}

LineReader::LineReader(const std::string& path, const std::optional<Shard>& shard)
    : name_(path == "-" ? "standard input" : "the file '" + path + "'") {
  const auto refuse = [&](const std::string& problem) {
    throw InvalidInput(name_ + " " + problem, "problems in JSON, one a line");
  };
  file_ = path == "-" ? dup(STDIN_FILENO) : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) refuse("cannot be opened: " + std::string(std::strerror(errno)));
  struct stat status {};
  fstat(file_, &status);
  if (S_ISDIR(status.st_mode)) refuse("is a directory");
  regular_ = S_ISREG(status.st_mode);
  if (!shard) return;
  if (!regular_ || path == "-")
    throw InvalidInput("option shard is given, but " + name_ + " cannot be cut into parts", "a regular file");
  find_shard(*shard, static_cast<std::uint64_t>(status.st_size));
}

LineReader::~LineReader() {
  if (file_ >= 0) close(file_);
}

void LineReader::find_shard(const Shard& shard, std::uint64_t size) {
  // Without the overflow of size * index.
  const auto cut = [&](std::uint64_t index) {
    return size / shard.count * index + size % shard.count * index / shard.count;
  };
  first_offset_ = cut(shard.index - 1);
  end_offset_ = cut(shard.index);
  // The lines before are only counted; the last of them may go beyond the cut.
  while (offset_ + block_size <= first_offset_ && read_block()) {
    line_ += static_cast<std::uint64_t>(std::count(block_.begin(), block_.end(), '\n'));
    if (const std::size_t last = block_.rfind('\n'); last != std::string::npos)
      line_offset_ = offset_ - block_.size() + last + 1;
    taken_ = block_.size();
  }
}

bool LineReader::read_block() {
  if (!regular_) {
    pollfd entry{file_, POLLIN, 0};
    if (poll(&entry, 1, 0) <= 0) return false;
  }
  block_.resize(block_size);
  taken_ = 0;
  ssize_t count = 0;
  do count = read(file_, block_.data(), block_size);
  while (count < 0 && errno == EINTR);
  if (count < 0) throw InvalidInput(name_ + " cannot be read: " + std::strerror(errno), "problems in JSON, one a line");
  block_.resize(static_cast<std::size_t>(count));
  offset_ += block_.size();
  at_end_ = count == 0;
  return count > 0;
}

std::optional<LineReader::Line> LineReader::finish_line(std::size_t end) {
  const std::size_t room = longest_line - std::min(longest_line, begun_.size());
  too_long_ = too_long_ || end - taken_ > room;
  Line line{line_, std::move(begun_), too_long_};
  line.text.append(block_, taken_, std::min(end - taken_, room));
  begun_.clear();
  too_long_ = false;
  const bool ours = line_offset_ >= first_offset_;
  if (line_ == 1 && line.text.starts_with("\xEF\xBB\xBF")) line.text.erase(0, 3);
  if (!line.too_long && line.text.ends_with('\r')) line.text.pop_back();
  taken_ = std::min(end + 1, block_.size());
  ++line_;
  line_offset_ = offset_ - block_.size() + taken_;
  if (!ours || line.text.find_first_not_of(blanks) == std::string::npos) return std::nullopt;
  return line;
}

std::optional<LineReader::Line> LineReader::next() {
  while (!at_end_) {
    if (end_offset_ && line_offset_ >= *end_offset_) {
      at_end_ = true;
      return std::nullopt;
    }
    const std::size_t end = block_.find('\n', taken_);
    if (end != std::string::npos) {
      if (auto line = finish_line(end)) return line;
      continue;
    }
    // The line goes on in the next block.
    const std::size_t room = longest_line - std::min(longest_line, begun_.size());
    too_long_ = too_long_ || block_.size() - taken_ > room;
    begun_.append(block_, taken_, std::min(block_.size() - taken_, room));
    taken_ = block_.size();
    if (!read_block() && !at_end_) return std::nullopt;
    if (at_end_ && !begun_.empty()) return finish_line(block_.size());
  }
  return std::nullopt;
}

}  // namespace eliminant::batch
