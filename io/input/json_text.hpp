// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <eliminant/base/text_place.hpp>

namespace eliminant::io {

struct JsonMember;

/// A JSON value that remembers where it stood. Numbers keep the digits of the file.
struct JsonValue {
  enum class Kind { null, boolean, number, text, array, object };
  Kind kind = Kind::null;
  /// Where its first character stands in the document, in bytes.
  std::size_t offset = 0;
  bool boolean = false;
  /// The decoded text, or the number as it was written.
  std::string text;
  std::vector<JsonValue> elements;
  std::vector<JsonMember> members;

  /// The member of this name, or nullptr.
  const JsonValue* find(std::string_view name) const;
  /// "a number", "an object", ... for messages.
  const char* kind_in_words() const;
};

struct JsonMember {
  std::string name;
  /// Where the name stands.
  std::size_t offset = 0;
  JsonValue value;
};

/// One JSON document (RFC 8259) with exact numbers and a place for every value.
class JsonDocument {
 public:
  /// Throws ParseError with the place of: a syntax error, a duplicate name in an object, NaN or Infinity, a comment,
  /// a number that JSON does not have (01, 1/2, 0x1p3), anything behind the value, more than 100 levels of nesting.
  explicit JsonDocument(std::string text);

  const JsonValue& root() const { return root_; }
  SourcePlace place_of(std::size_t offset) const { return place_in(text_, offset); }
  SourcePlace place_of(const JsonValue& value) const { return place_of(value.offset); }
  /// Places inside the content of a text or number value, escapes counted as they stand in the document.
  Locate locate_inside(const JsonValue& value) const;

 private:
  std::string text_;
  JsonValue root_;
};

}  // namespace eliminant::io
