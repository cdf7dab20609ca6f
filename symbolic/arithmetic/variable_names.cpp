// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/variable_names.hpp>

#include <algorithm>

namespace eliminant::symbolic {

namespace {

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Length in bytes of the letter that `text` begins with, 0 for anything else. Only two-byte UTF-8 sequences hold the
// alphabets meant here; other symbols (a typographic minus, a middle dot, a superscript) must not become names.
std::size_t letter_length(std::string_view text) {
  if (text.empty()) return 0;
  if (is_ascii_letter(text[0])) return 1;
  const unsigned lead = static_cast<unsigned char>(text[0]);
  if (lead < 0xC3 || lead > 0xD3 || text.size() < 2) return 0;
  const unsigned trail = static_cast<unsigned char>(text[1]);
  if ((trail & 0xC0U) != 0x80U) return 0;
  const unsigned code_point = ((lead & 0x1FU) << 6U) | (trail & 0x3FU);
  const bool latin = code_point >= 0xC0 && code_point <= 0x24F && code_point != 0xD7 && code_point != 0xF7;
  const bool greek = code_point >= 0x391 && code_point <= 0x3FF;
  const bool cyrillic = code_point >= 0x400 && code_point <= 0x481;
  return latin || greek || cyrillic ? 2 : 0;
}

}  // namespace

std::size_t identifier_length(std::string_view text) {
  std::size_t length = letter_length(text);
  if (length == 0) return 0;
  while (length < text.size()) {
    const std::size_t step = is_digit(text[length]) ? 1 : letter_length(text.substr(length));
    if (step == 0) break;
    length += step;
  }
  return length;
}

bool is_identifier(std::string_view text) { return !text.empty() && identifier_length(text) == text.size(); }

VariableSplit split_into_variables(std::string_view identifier, std::span<const std::string> names) {
  const auto whole = std::find(names.begin(), names.end(), identifier);
  if (whole != names.end()) return {VariableSplit::Outcome::unique, {static_cast<std::size_t>(whole - names.begin())}};

  // ways[i] counts, up to 2, the products that spell the first i bytes; last[i] is the last factor of such a product.
  std::vector<int> ways(identifier.size() + 1, 0);
  std::vector<std::size_t> last(identifier.size() + 1, 0);
  ways[0] = 1;
  for (std::size_t i = 1; i <= identifier.size(); ++i) {
    for (std::size_t v = 0; v < names.size(); ++v) {
      const std::string& name = names[v];
      if (name.empty() || name.size() > i || identifier.substr(i - name.size(), name.size()) != name) continue;
      if (ways[i - name.size()] == 0) continue;
      ways[i] = std::min(2, ways[i] + ways[i - name.size()]);
      last[i] = v;
    }
  }
  if (ways.back() == 0) return {VariableSplit::Outcome::none, {}};
  if (ways.back() > 1) return {VariableSplit::Outcome::ambiguous, {}};
  VariableSplit result{VariableSplit::Outcome::unique, {}};
  for (std::size_t i = identifier.size(); i > 0; i -= names[last[i]].size()) result.variables.push_back(last[i]);
  std::reverse(result.variables.begin(), result.variables.end());
  return result;
}

}  // namespace eliminant::symbolic
