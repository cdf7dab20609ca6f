// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/io/results/json_fields.hpp>

namespace eliminant::io {

/// A surface of a problem file (docs/formats.md): a rational map, {"bezier": ...}, {"triangle": ...}, {"nurbs": ...},
/// {"pieces": [...]} or {"implicit": ...}. `what` names the object in messages: "\"surface\"". All numbers are exact.
/// Throws ParseError and InvalidInput with the place of what is not as expected, and LimitReached with the place of
/// what is too large; a map whose image is only a curve or a point is an InvalidInput.
intersect::Surface read_surface(const JsonFields& fields, const JsonValue& value, const std::string& what);

}  // namespace eliminant::io
