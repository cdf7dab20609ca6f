// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <eliminant/base/text_place.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/io/input/json_text.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>

namespace eliminant::io {

/// A polynomial as its author wrote it; `name` ("p") stands in error messages.
struct PolynomialText {
  std::string name;
  std::string text;
  Locate locate;
};

/// Reads the two polynomials. Without `variables` they are the names that occur, sorted, completed by x, then y.
/// Throws ParseError, LimitReached, and InvalidInput when more than two names occur.
intersect::PlaneCurvesProblem plane_curves_from_text(const PolynomialText& p, const PolynomialText& q,
                                                     const std::optional<std::vector<std::string>>& variables,
                                                     const symbolic::Limits& limits);

/// Throws InvalidInput, with `place`, unless there are two different identifiers.
void require_two_variables(const std::vector<std::string>& variables, SourcePlace place);

/// `x, y` -> {"x", "y"}: cut at commas, blanks removed.
std::vector<std::string> split_at_commas(std::string_view text);

/// A value [[a, b], [c, d]] with a <= b, c <= d; the entries are numbers or texts. Throws InvalidInput with the place.
intersect::Box box_from_json(const JsonDocument& document, const JsonValue& value, const symbolic::Limits& limits);

}  // namespace eliminant::io
