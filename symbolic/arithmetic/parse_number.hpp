// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include <eliminant/base/text_place.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::symbolic {

/// Length of the longest unsigned number literal that `text` begins with, 0 when there is none. A literal is
/// `12`, `0.1`, `.5`, `5.`, any of them with a decimal exponent (`1e-3`), or hexadecimal with a binary exponent
/// (`0x1.8p-3`). An `e`, `p` or `0x` that no digit follows is not part of it: `2e` begins with the literal `2`.
std::size_t number_literal_length(std::string_view text);

/// The exact value of an unsigned number literal, never rounded: 0.1 is 1/10. `literal` must be one in full.
/// Throws LimitReached, without a place, when it has too many digits or too large an exponent.
Rational number_literal_value(std::string_view literal, const Limits& limits);

/// The exact value of `text`: a literal or a fraction of two literals, an optional sign before each, blanks around.
/// Throws ParseError on anything else (also a zero denominator) and LimitReached; both with the place, found by
/// `locate` (by default in `text` itself).
Rational parse_number(std::string_view text, const Limits& limits = {}, const Locate& locate = {});

}  // namespace eliminant::symbolic
