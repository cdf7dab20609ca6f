// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/io/input/run_options.hpp>

namespace eliminant::io {

/// The intersection of two surfaces, or of one with itself, for people: what there is, the components with their ends,
/// the singular points. The points of the curves are in the other formats.
std::string surface_result_text(const intersect::SurfaceResult& result, const RunOptions& options);

}  // namespace eliminant::io
