// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::symbolic {

/// Length of the longest identifier that `text` begins with, 0 when there is none: letters of the Latin, Greek and
/// Cyrillic alphabets (UTF-8) and `_`, then also digits.
std::size_t identifier_length(std::string_view text);

/// Whether all of `text` is one identifier.
bool is_identifier(std::string_view text);

/// The ways to write an identifier as a product of variables.
struct VariableSplit {
  enum class Outcome { unique, none, ambiguous };
  Outcome outcome = Outcome::none;
  /// Indices into the names, in the order in which they occur; only for `unique`.
  std::vector<std::size_t> variables;
};

/// Reads `identifier` as one of `names` or, if it is none of them, as a product of them (`xy` = x*y).
VariableSplit split_into_variables(std::string_view identifier, std::span<const std::string> names);

}  // namespace eliminant::symbolic
