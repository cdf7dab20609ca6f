// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/intersect/curve_surface/implicitize.hpp>
#include <eliminant/io/results/json_fields.hpp>

namespace eliminant::io {

/// The curve or surface in the field "curve" or "surface" of `object`, exactly one of which must be there; with a
/// parameter, not given by an equation.
/// Throws ParseError and InvalidInput with the place of what is not as expected, and LimitReached.
intersect::ImplicitizeProblem read_implicitize(const JsonFields& fields, const JsonValue& object);

/// The same from an object that is a curve or surface itself; which one its fields say.
intersect::ImplicitizeProblem read_bare_geometry(const JsonFields& fields, const JsonValue& object);

}  // namespace eliminant::io
