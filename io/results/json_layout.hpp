// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace eliminant::io {

/// JSON for people and programs: every array or object that fits into `width` columns stands on one line, so that a
/// solution is a line; longer ones are broken and indented. Ends with a newline.
std::string json_layout(const nlohmann::ordered_json& value, std::size_t width = 160);

/// The same on one line, without a newline.
std::string json_line(const nlohmann::ordered_json& value);

/// The text of json_layout as json_line writes it: without its line breaks and indentation.
std::string json_on_one_line(const std::string& layout);

}  // namespace eliminant::io
