// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/stated_kind.hpp>

#include <eliminant/io/input/json_text.hpp>

namespace eliminant::io {

namespace {

// Longer than any kind there will be: what is not repeated in a report.
constexpr std::size_t longest_kind = 40;

}  // namespace

std::optional<std::string> stated_kind(const std::string& text, ProblemSyntax syntax) noexcept {
  if (syntax == ProblemSyntax::msolve) return "plane_curves";
  try {
    const JsonDocument document(text);
    const JsonValue* const kind = document.root().find("problem");
    if (kind == nullptr || kind->kind != JsonValue::Kind::text || kind->text.size() > longest_kind) return std::nullopt;
    return kind->text;
  } catch (...) {
    return std::nullopt;
  }
}

}  // namespace eliminant::io
