// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <eliminant/base/text_place.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// The polynomial in Q[names] that `text` writes, expanded, with repeated monomials added. Grammar (docs/formats.md):
///   sum      = product { ("+" | "-") product }
///   product  = factor { [ "*" | "/" ] factor }      without sign: only before a name or "("; left to right
///   factor   = { "+" | "-" } power
///   power    = operand [ ("^" | "**") factor ]
///   operand  = number | name | "(" sum ")"
/// Only numbers divide, and only whole numbers >= 0 (any whole number over a number) are exponents. A name that is none
/// of `names` is read as their product where that is possible in one way. x^0 is 1, also for x = 0.
/// Throws ParseError and LimitReached, both with the place that `locate` gives (by default in `text` itself); every
/// limit is checked before anything is expanded.
Polynomial parse_polynomial(std::string_view text, std::span<const std::string> names, const Limits& limits = {},
                            const Locate& locate = {});

/// One name of a polynomial text and where it first occurs.
struct NameOccurrence {
  std::string name;
  std::size_t offset = 0;
};

/// The identifiers of `text` in the order of their first occurrence, for a text whose variables were not declared.
/// Throws ParseError at a character outside the grammar, and where a name of several letters is followed by "(", which
/// looks like a function call.
std::vector<NameOccurrence> names_in(std::string_view text, const Locate& locate = {});

}  // namespace eliminant::symbolic
