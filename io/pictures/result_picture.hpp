// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/pictures/picture.hpp>

namespace eliminant::io {

/// The picture of a result in JSON (docs/formats.md): of two surfaces or of a surface with itself the parameter planes
/// and the curve in space, of a plane curve its vertices and arcs, of two plane curves their real common points.
/// Throws ParseError for a text that is no JSON, and InvalidInput for one that is no result, for an error and for a
/// result of another kind.
Picture result_picture(const std::string& text);

}  // namespace eliminant::io
