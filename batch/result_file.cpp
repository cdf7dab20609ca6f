// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/result_file.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <sstream>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/io/results/error_report.hpp>

namespace eliminant::batch {

namespace {

constexpr const char* state_heading = "eliminant batch state 2\n";
// Seconds between two notes of the state.
constexpr double note_interval = 0.1;

// A quote inside a text is escaped: this can only be the field of a result.
constexpr std::string_view incomplete_field = "\"status\": \"incomplete\"";

// The whole file, from its beginning.
std::string read_all(int file) {
  std::string text;
  std::vector<char> block(std::size_t{1} << 16U);
  lseek(file, 0, SEEK_SET);
  while (true) {
    const ssize_t count = read(file, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
}

bool is_result(std::string_view line) { return line.starts_with('{') && line.ends_with('}'); }

std::string hexadecimal(std::uint64_t value) {
  std::array<char, 17> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, 16);
  return error == std::errc{} ? std::string(text.data(), end) : std::string();
}

// "NUMBER HASH".
std::optional<std::pair<std::uint64_t, std::uint64_t>> parse_note(std::string_view line) {
  std::pair<std::uint64_t, std::uint64_t> note;
  const char* const end = line.data() + line.size();
  const auto number = std::from_chars(line.data(), end, note.first);
  if (number.ec != std::errc{} || number.ptr == end || *number.ptr != ' ') return std::nullopt;
  const auto hash = std::from_chars(number.ptr + 1, end, note.second, 16);
  if (hash.ec != std::errc{} || hash.ptr != end) return std::nullopt;
  return note;
}

}  // namespace

ResultFile::ResultFile(std::optional<std::string> path, bool resume, const std::string& description)
    : name_(path ? "'" + *path + "'" : "standard output") {
  file_ = path ? open(path->c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666) : dup(STDOUT_FILENO);
  // A pipe or a device may allow writing alone.
  if (file_ < 0 && path) file_ = open(path->c_str(), O_WRONLY | O_CLOEXEC);
  if (file_ < 0) fail(name_);
  struct stat status {};
  fstat(file_, &status);
  const bool regular = path && S_ISREG(status.st_mode);
  if (resume && !regular)
    throw InvalidInput("option resume is given, but " + name_ + " cannot be continued", "-o FILE, a regular file");
  if (!regular) return;
  state_name_ = *path + ".state";
  lock();
  if (resume && status.st_size > 0) {
    keep_results(description);
  } else {
    if (ftruncate(file_, 0) != 0) fail(name_);
    begin_state(description);
  }
}

ResultFile::~ResultFile() {
  if (file_ >= 0) close(file_);
  if (state_ >= 0) close(state_);
}

void ResultFile::fail(const std::string& name) const {
  throw io::OutputError("cannot write " + name + ": " + std::strerror(errno));
}

// A lock of the process, which its workers do not inherit: it ends with this process, however that ends.
void ResultFile::lock() {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(file_, F_SETLK, &whole) == 0) return;
  if (errno != EAGAIN && errno != EACCES) return;
  throw io::OutputError("cannot write " + name_ + ": another run is writing it");
}

void ResultFile::keep_results(const std::string& description) {
  state_ = open(state_name_.c_str(), O_RDWR | O_CLOEXEC);
  if (state_ < 0)
    throw InvalidInput(name_ + " cannot be continued: there is no '" + state_name_ + "' that says what it belongs to",
                       "the output of an earlier run of batch, or none");
  read_state(description);
  whole_size_ = count_results();
}

void ResultFile::drop_torn() {
  if (!whole_size_) return;
  const auto cut = [&](int file, const std::string& name, std::uint64_t size) {
    if (ftruncate(file, static_cast<off_t>(size)) != 0 || lseek(file, 0, SEEK_END) < 0) fail(name);
  };
  cut(file_, name_, *whole_size_);
  cut(state_, "'" + state_name_ + "'", whole_state_size_);
  whole_size_.reset();
}

// Counts the results that are whole, and returns where the last of them ends.
std::uint64_t ResultFile::count_results() {
  std::vector<char> block(std::size_t{1} << 20U);
  std::string begun;
  std::uint64_t size = 0;
  lseek(file_, 0, SEEK_SET);
  while (true) {
    const ssize_t count = read(file_, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(name_);
    if (count == 0) return size;
    std::string_view rest(block.data(), static_cast<std::size_t>(count));
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
      begun.append(rest.substr(0, end));
      // What a power failure leaves behind may be no text at all.
      if (!is_result(begun)) return size;
      size += begun.size() + 1;
      ++kept_;
      if (begun.find(incomplete_field) != std::string::npos) ++kept_incomplete_;
      begun.clear();
      rest.remove_prefix(end + 1);
    }
    begun.append(rest);
  }
}

void ResultFile::read_state(const std::string& description) {
  const std::string text = read_all(state_);
  std::istringstream lines(text);
  std::string line;
  std::string described;
  std::getline(lines, line);
  std::getline(lines, described);
  if (line + "\n" != state_heading)
    throw InvalidInput("'" + state_name_ + "' is no state of a batch", "the state that was written with " + name_);
  if (described != description)
    throw InvalidInput(name_ + " belongs to another run: that was " + described + ", this is " + description,
                       "the same options, or another output");
  whole_state_size_ = line.size() + described.size() + 2;
  while (std::getline(lines, line) && !lines.eof()) {
    const auto note = parse_note(line);
    if (!note) break;
    noted_.insert(*note);
    whole_state_size_ += line.size() + 1;
  }
}

void ResultFile::begin_state(const std::string& description) {
  state_ = open(state_name_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (state_ < 0) fail("'" + state_name_ + "'");
  write_all(state_, "'" + state_name_ + "'", state_heading + description + "\n");
}

void ResultFile::check_kept(std::uint64_t number, std::uint64_t hash) const {
  const auto note = noted_.find(number);
  if (number > kept_ || note == noted_.end() || note->second == hash) return;
  throw InvalidInput(
      name_ + " belongs to other problems: one of the first " + std::to_string(number) + " lines is not what it was",
      "the same problems, or another output");
}

void ResultFile::refuse_kept(std::uint64_t lines) const {
  throw InvalidInput(name_ + " belongs to other problems: it has " + std::to_string(kept_) +
                         " results, and there are only " + std::to_string(lines) + " problems",
                     "the same problems, or another output");
}

void ResultFile::append(const std::string& lines, std::uint64_t number, std::uint64_t hash) {
  write_all(file_, name_, lines);
  if (state_ < 0) return;
  const auto now = std::chrono::steady_clock::now();
  if (std::chrono::duration<double>(now - last_note_).count() < note_interval) {
    unnoted_ = {number, hash};
    return;
  }
  note(number, hash);
  last_note_ = now;
}

void ResultFile::note(std::uint64_t number, std::uint64_t hash) {
  write_all(state_, "'" + state_name_ + "'", std::to_string(number) + " " + hexadecimal(hash) + "\n");
  unnoted_.reset();
}

void ResultFile::finish() {
  if (unnoted_) note(unnoted_->first, unnoted_->second);
  // What is no file cannot be waited for (EINVAL).
  if (fsync(file_) != 0 && errno != EINVAL && errno != EROFS) fail(name_);
  const int file = std::exchange(file_, -1);
  if (close(file) != 0) fail(name_);
}

void ResultFile::write_all(int file, const std::string& name, const std::string& bytes) const {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t count = write(file, bytes.data() + at, bytes.size() - at);
    if (count > 0) {
      at += static_cast<std::size_t>(count);
    } else if (count < 0 && errno == EAGAIN) {
      pollfd entry{file, POLLOUT, 0};
      poll(&entry, 1, -1);
    } else if (count == 0 || errno != EINTR) {
      fail(name);
    }
  }
}

}  // namespace eliminant::batch
