// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::io {

/// The words of a JSON text that make values or names, in their order: what a parser that reports no places needs in
/// order to get them back.
struct JsonWords {
  /// Where each "{", "[", text, number, true, false and null begins, in bytes.
  std::vector<std::size_t> offsets;
  /// The bare numbers as written.
  std::vector<std::string> numbers;
  /// The text, equally long, with each bare number replaced by 0 and blanks, so that no parser can round it.
  std::string without_numbers;
};

/// Walks through `text`, aware of what is inside quotes. Throws ParseError where a bare word is no JSON: NaN, Infinity,
/// 01, +1, .5, 1/2, 0x10, comments, single quotes, a control character inside quotes, a text without end.
JsonWords json_words(std::string_view text);

}  // namespace eliminant::io
