// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace eliminant::batch {

/// A number that stands for all lines added so far, their order and where they stand: FNV-1a of 64 bits. It finds
/// mistakes, not malice.
class LineHash {
 public:
  /// `number` is that of the line in its file: results of lines that are no problems hold it.
  void add(std::uint64_t number, std::string_view line) {
    for (int byte = 0; byte < 8; ++byte) add_byte(static_cast<unsigned char>(number >> (8 * byte)));
    for (const char c : line) add_byte(static_cast<unsigned char>(c));
    add_byte('\n');
  }
  std::uint64_t value() const { return value_; }

 private:
  void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3U; }
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace eliminant::batch
