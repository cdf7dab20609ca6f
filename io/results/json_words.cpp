// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/json_words.hpp>

#include <algorithm>

#include <eliminant/base/text_place.hpp>

namespace eliminant::io {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// RFC 8259, section 6: -?(0|[1-9][0-9]*)(.[0-9]+)?([eE][+-]?[0-9]+)?
bool is_json_number(std::string_view word) {
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < word.size() && is_digit(word[at])) ++at;
    return at - begin;
  };
  const auto accept = [&](char a, char b) {
    const bool found = at < word.size() && (word[at] == a || word[at] == b);
    if (found) ++at;
    return found;
  };
  accept('-', '-');
  const std::size_t first = at;
  const std::size_t whole = digits();
  if (whole == 0 || (whole > 1 && word[first] == '0')) return false;
  if (accept('.', '.') && digits() == 0) return false;
  if (accept('e', 'E')) {
    accept('+', '-');
    if (digits() == 0) return false;
  }
  return at == word.size();
}

class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) { words_.without_numbers = text; }

  JsonWords run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"') {
        quoted();
      } else if (c == '{' || c == '[') {
        words_.offsets.push_back(at_++);
      } else if (is_digit(c) || is_letter(c) || c == '-' || c == '+' || c == '.') {
        bare_word();
      } else if (c == '/' || c == '#') {
        refuse("unexpected '" + std::string(1, c) + "': JSON has no comments", "a JSON value or punctuation");
      } else if (c == '\'') {
        refuse("unexpected single quote", "text in double quotes");
      } else if (std::string_view(" \t\r\n]},:").find(c) == std::string_view::npos) {
        refuse("unexpected '" + character() + "'", "a JSON value or punctuation");
      } else {
        ++at_;
      }
    }
    return std::move(words_);
  }

 private:
  [[noreturn]] void refuse(const std::string& message, const std::string& expected) const {
    throw ParseError(message, expected, place_in(text_, at_));
  }

  // The UTF-8 character here.
  std::string character() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
    return std::string(text_.substr(at_, end - at_));
  }

  // Length of the escape here, with its backslash.
  std::size_t escape() const {
    const std::string_view rest = text_.substr(at_);
    if (rest.size() > 1 && std::string_view("\"\\/bfnrt").find(rest[1]) != std::string_view::npos) return 2;
    const bool hexadecimal = rest.size() >= 6 && rest[1] == 'u' &&
                             rest.substr(2, 4).find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
    if (!hexadecimal) refuse("a text has an escape that JSON does not have", "\\n, \\\\, \\\" or \\u and four digits");
    return 6;
  }

  void quoted() {
    const std::size_t begin = at_;
    words_.offsets.push_back(at_++);
    while (true) {
      if (at_ >= text_.size()) {
        at_ = begin;
        refuse("a text has no end", "a closing double quote");
      }
      const char c = text_[at_];
      if (static_cast<unsigned char>(c) < 0x20)
        refuse(c == '\n' ? "a text runs over the end of the line" : "a control character stands inside a text",
               c == '\n' ? "a closing double quote" : "an escape such as \\n or \\u0001");
      if (c == '"') break;
      at_ += c == '\\' ? escape() : 1;
    }
    ++at_;
  }

  void bare_word() {
    std::size_t end = at_;
    const auto belongs = [](char c) {
      return is_digit(c) || is_letter(c) || c == '-' || c == '+' || c == '.' || c == '/';
    };
    while (end < text_.size() && belongs(text_[end])) ++end;
    const std::string_view word = text_.substr(at_, end - at_);
    const std::string shown = "'" + std::string(word.substr(0, 30)) + (word.size() > 30 ? "...'" : "'");
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const std::string unsigned_word = lower.substr(lower.find_first_not_of("+-") == 1 ? 1 : 0);
    if (unsigned_word == "nan" || unsigned_word == "inf" || unsigned_word == "infinity")
      refuse(shown + " is no number", "a finite number");
    if (is_letter(word.front())) {
      if (word != "true" && word != "false" && word != "null")
        refuse("unexpected " + shown, "a JSON value; text stands in double quotes");
      words_.offsets.push_back(at_);
    } else {
      if (!is_json_number(word))
        refuse(shown + " is no JSON number", "a number such as -1.5e3, or other notations in double quotes");
      words_.offsets.push_back(at_);
      words_.numbers.emplace_back(word);
      std::fill_n(words_.without_numbers.begin() + static_cast<std::ptrdiff_t>(at_), word.size(), ' ');
      words_.without_numbers[at_] = '0';
    }
    at_ = end;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  JsonWords words_;
};

}  // namespace

JsonWords json_words(std::string_view text) { return Walk(text).run(); }

}  // namespace eliminant::io
