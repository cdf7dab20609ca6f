// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>

namespace eliminant::io {

/// The result for people: what was looked for, and a table of the cylinders with five digits, which is more than noise
/// leaves right.
std::string cylinder_extraction_text(const intersect::CylinderExtractionResult& result);

}  // namespace eliminant::io
