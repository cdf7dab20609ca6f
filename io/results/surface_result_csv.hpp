// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::io {

/// The points of the components as CSV (docs/formats.md), a line each.
std::string surface_result_csv(const intersect::SurfaceResult& result);

}  // namespace eliminant::io
