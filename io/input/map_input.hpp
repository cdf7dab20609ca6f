// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <eliminant/io/results/json_fields.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/domain.hpp>

namespace eliminant::io {

/// The parts of a rational map that curves and surfaces share. Whatever is not as expected is an InvalidInput or
/// ParseError with its place; what is too large is a LimitReached.

/// The name of a parameter.
std::string parameter_name(const JsonFields& fields, const JsonValue& value);

/// The polynomial in these variables that the text or number `value` writes; `name` begins its messages.
symbolic::Polynomial polynomial_from_json(const JsonFields& fields, const JsonValue& value, const std::string& name,
                                          const std::vector<std::string>& variables);

/// [lower, upper] with lower <= upper.
symbolic::Interval interval_from_json(const JsonFields& fields, const JsonValue& value, const std::string& what);

/// The equation of {"implicit": "..."} in these variables, which must not be constant. `what` is "the curve" or so.
symbolic::Polynomial implicit_equation(const JsonFields& fields, const JsonValue& object, const std::string& what,
                                       const std::vector<std::string>& variables);

}  // namespace eliminant::io
