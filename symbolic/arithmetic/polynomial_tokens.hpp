// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include <eliminant/base/text_place.hpp>

namespace eliminant::symbolic {

/// One word of a polynomial text.
struct PolynomialToken {
  enum class Kind { number, name, plus, minus, times, divide, power, open, close, end };
  Kind kind = Kind::end;
  /// Where it begins, in bytes.
  std::size_t offset = 0;
  std::string_view text;
};

/// Cuts a polynomial text into words: number literals, identifiers, + - * / ^ ** ( ), blanks between them. The text
/// must outlive the reader. Any other character throws ParseError, with a hint where a common notation is meant.
class PolynomialTokens {
 public:
  PolynomialTokens(std::string_view text, Locate locate) : text_(text), locate_(std::move(locate)) { advance(); }

  const PolynomialToken& current() const { return current_; }
  void advance();
  SourcePlace place_of(std::size_t offset) const { return locate_(offset); }
  SourcePlace place() const { return locate_(current_.offset); }

 private:
  [[noreturn]] void refuse_character() const;

  std::string_view text_;
  Locate locate_;
  std::size_t at_ = 0;
  PolynomialToken current_;
};

}  // namespace eliminant::symbolic
