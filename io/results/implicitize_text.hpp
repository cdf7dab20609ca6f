// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/intersect/curve_surface/implicitize.hpp>

namespace eliminant::io {

/// A result of `implicitize` for people: each representation with its sizes, ranks and degrees, the matrix, and the
/// equation where there is one.
std::string implicitize_text(const intersect::ImplicitizeResult& result, bool with_seconds = true);

}  // namespace eliminant::io
