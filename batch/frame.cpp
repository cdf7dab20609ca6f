// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/frame.hpp>

#include <cstring>

namespace eliminant::batch {

namespace {

struct Heading {
  std::uint64_t number;
  std::uint64_t line;
  std::uint64_t size;
  std::uint32_t kind;
  std::uint32_t unused;
};

}  // namespace

void append_frame(const Frame& frame, std::string& bytes) {
  const Heading heading{frame.number, frame.line, frame.text.size(), static_cast<std::uint32_t>(frame.kind), 0};
  bytes.append(reinterpret_cast<const char*>(&heading), sizeof heading);
  bytes += frame.text;
}

std::optional<Frame> FrameAssembly::next() {
  Heading heading{};
  const std::size_t left = bytes_.size() - taken_;
  if (left < sizeof heading) return std::nullopt;
  std::memcpy(&heading, bytes_.data() + taken_, sizeof heading);
  if (left - sizeof heading < heading.size) {
    bytes_.reserve(taken_ + sizeof heading + heading.size);
    return std::nullopt;
  }
  Frame frame{static_cast<Frame::Kind>(heading.kind), heading.number, heading.line,
              bytes_.substr(taken_ + sizeof heading, heading.size)};
  taken_ += sizeof heading + heading.size;
  if (taken_ == bytes_.size()) {
    taken_ = 0;
    // A large frame leaves no large buffer behind.
    if (bytes_.capacity() > (std::size_t{1} << 20U))
      std::string().swap(bytes_);
    else
      bytes_.clear();
  }
  return frame;
}

}  // namespace eliminant::batch
