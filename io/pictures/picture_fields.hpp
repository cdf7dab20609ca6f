// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/pictures/picture.hpp>

namespace eliminant::io {

// Reading a result for its picture.

/// The number that a text or a number holds, rounded; `inf` and `-inf`; NaN for anything else.
double number_in(const JsonValue* value);

/// The text or number that stands there; empty where there is none.
std::string text_in(const JsonValue* value);

/// The elements of an array; none where there is no array.
const std::vector<JsonValue>& elements_in(const JsonValue* value);

/// "true" or "false" as "yes" or "no", empty for anything else.
std::string yes_or_no(const JsonValue* value);

/// Adds a mark to the legend that is not there yet.
void explain(Picture& picture, PictureShape shape, const std::string& text);

/// The picture of a result of `surface_surface`, or of `self_intersection` of a surface.
void draw_surface_result(Picture& picture, const JsonValue& result);

/// The picture of a result of `cylinder_extraction`.
void draw_cylinder_extraction(Picture& picture, const JsonValue& result);

}  // namespace eliminant::io
