// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/io/results/json_fields.hpp>

namespace eliminant::io {

/// Reads "points": five points of three numbers each. Throws InvalidInput, ParseError and LimitReached, each with its
/// place and the number of the point.
intersect::CylindersProblem read_cylinders(const JsonFields& fields, const JsonValue& problem);

}  // namespace eliminant::io
