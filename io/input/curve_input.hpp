// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/io/results/json_fields.hpp>

namespace eliminant::io {

/// Curves of problem files (docs/formats.md): a rational map, {"bezier": ...}, {"nurbs": ...}, {"pieces": [...]} or
/// {"implicit": ...}. `what` names the object in messages: "\"first\"". All numbers are exact.
/// All throw ParseError and InvalidInput with the place of what is not as expected, and LimitReached with the place of
/// what is too large; a curve that is a single point is an InvalidInput.

/// A curve in the plane or in space. Control points [x, y, 0, w] alone make a plane curve.
intersect::Curve read_curve(const JsonFields& fields, const JsonValue& value, const std::string& what);

/// A parametrised curve in space; control points [x, y, 0, w] alone make a space curve here.
symbolic::ParametricCurve read_space_curve(const JsonFields& fields, const JsonValue& value, const std::string& what);

/// The curves of "first" and "second", both in the plane or both in space; control points [x, y, 0, w] alone follow the
/// other curve.
std::array<intersect::Curve, 2> read_curve_pair(const JsonFields& fields, const JsonValue& first,
                                                const JsonValue& second);

}  // namespace eliminant::io
