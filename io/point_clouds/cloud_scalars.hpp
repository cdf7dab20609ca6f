// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::io {

// Numbers of point clouds, in text and in bytes.

/// A type of number of PLY and PCD files.
enum class ScalarType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

std::size_t size_of(ScalarType type);

/// The number whose bytes begin at `bytes`, rounded to a double.
double scalar_at(const char* bytes, ScalarType type, bool big_endian);

/// A decimal number, `nan` or `inf`, with an optional sign; nothing when the word is anything else or too large.
std::optional<double> double_in(std::string_view word);

/// A whole number without sign; nothing when the word is anything else or too large.
std::optional<std::size_t> count_in(std::string_view word);

/// A word for a message: between quotes, cut to 40 characters, with ? for what cannot be printed.
std::string quoted_word(std::string_view word);

/// The words between blanks and tabs.
std::vector<std::string_view> words_of(std::string_view line);

/// The lines of a text, one after the other, without their ends: a line feed, a carriage return, or both. Where the
/// first line ends in a carriage return alone, all do: the line feed after one is the first byte of what follows a
/// header.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : text_(text) {}

  /// False at the end of the text.
  bool next(std::string_view& line);
  /// The number of the last line, from 1.
  std::size_t number() const { return number_; }
  /// Where the next line begins, in bytes.
  std::size_t offset() const { return offset_; }

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t number_ = 0;
  bool ends_in_return_ = false;
};

}  // namespace eliminant::io
