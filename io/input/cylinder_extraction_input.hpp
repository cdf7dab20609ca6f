// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <eliminant/io/results/json_fields.hpp>

namespace eliminant::io {

/// Reads "cloud" (the file, relative to `folder`) with its points, "distance" and the optional "min_radius",
/// "max_radius", "min_inliers" and "confidence". Throws InvalidInput, ParseError and LimitReached with the place in the
/// problem; what is wrong with the cloud names its line or byte.
intersect::CylinderExtractionProblem read_cylinder_extraction(const JsonFields& fields, const JsonValue& problem,
                                                              const std::string& folder);

}  // namespace eliminant::io
