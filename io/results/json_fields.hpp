// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include <eliminant/io/input/json_text.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::io {

/// Reads fields of JSON objects; whatever is not as expected is an InvalidInput with its place.
class JsonFields {
 public:
  explicit JsonFields(const JsonDocument& document, symbolic::Limits limits = {})
      : document_(document), limits_(limits) {}

  /// The member, which must be there; `expected` says what it would hold.
  const JsonValue& member(const JsonValue& object, const std::string& name,
                          const std::string& expected = "an object with it") const;
  /// Throws unless `value` is an object with no other members than these.
  void require_object(const JsonValue& value, const std::string& what, std::initializer_list<const char*> names) const;
  const std::vector<JsonValue>& array(const JsonValue& value, const std::string& what) const;
  const std::string& text(const JsonValue& value, const std::string& what) const;
  bool boolean(const JsonValue& value, const std::string& what) const;
  /// A number or a number written as text, exactly.
  symbolic::Rational number(const JsonValue& value, const std::string& what) const;
  /// A whole number of this range.
  long integer(const JsonValue& value, const std::string& what, long lowest, long highest) const;

  const JsonDocument& document() const { return document_; }
  const symbolic::Limits& limits() const { return limits_; }
  [[noreturn]] void refuse(const JsonValue& value, const std::string& what, const std::string& expected) const;

 private:
  const JsonDocument& document_;
  symbolic::Limits limits_;
};

}  // namespace eliminant::io
