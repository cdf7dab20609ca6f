// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace eliminant::batch {

/// One message between the processes of a batch.
struct Frame {
  enum class Kind : std::uint32_t {
    /// A problem to solve: its text.
    task,
    /// Its result: one line of JSON.
    result,
    /// A result from a process whose memory was exhausted, and which is not to be used again.
    exhausted,
    /// A problem that comes back as nobody has begun with it. No text.
    returned,
    /// There is nothing more to do. No text.
    finish,
  };
  Kind kind = Kind::task;
  /// Which problem, counted from 0 without blank lines.
  std::uint64_t number = 0;
  /// Its line in the file, counted from 1.
  std::uint64_t line = 0;
  std::string text;
};

/// Appends the bytes of `frame` to `bytes`: a heading of fixed size, in the byte order of this machine, and the text.
void append_frame(const Frame& frame, std::string& bytes);

/// Bytes as they arrive, cut into frames.
class FrameAssembly {
 public:
  void add(const char* bytes, std::size_t size) { bytes_.append(bytes, size); }
  /// The next frame, or nullopt while it is not complete.
  std::optional<Frame> next();

 private:
  std::string bytes_;
  std::size_t taken_ = 0;
};

}  // namespace eliminant::batch
