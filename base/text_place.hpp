// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>

#include <eliminant/base/error.hpp>

namespace eliminant {

/// The place of a byte offset in UTF-8 `text`: lines end at '\n', a column is one code point. An offset behind the end
/// gives the place after the last character.
inline SourcePlace place_in(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  SourcePlace place{1, 1};
  for (const char c : before) {
    const bool continuation_byte = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
    if (c == '\n') {
      ++place.line;
      place.column = 1;
    } else if (!continuation_byte) {
      ++place.column;
    }
  }
  return place;
}

/// Turns a byte offset of a text that was cut out of a larger one into a place of the larger one. Whoever parses a
/// polynomial inside a file hands one over, so that errors name the place in the file.
using Locate = std::function<SourcePlace(std::size_t offset)>;

/// The Locate of a text that stands alone. The view must outlive it.
inline Locate locate_in(std::string_view text) {
  return [text](std::size_t offset) { return place_in(text, offset); };
}

/// Runs `compute`; a LimitReached without a place gets that of `offset`.
template <class LocateOffset, class Compute>
auto with_place(const LocateOffset& locate, std::size_t offset, Compute compute) {
  try {
    return compute();
  } catch (const LimitReached& limit) {
    if (limit.place().line != 0) throw;
    throw LimitReached(limit.what(), locate(offset));
  }
}

}  // namespace eliminant
