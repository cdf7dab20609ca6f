// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace eliminant::io {

/// The content of the file `path`, or of standard input for "-": UTF-8 text that is not empty, without a byte order
/// mark. Throws InvalidInput for a missing or unreadable file, a directory, a binary or empty file and invalid UTF-8,
/// and LimitReached for more than 1 GiB.
std::string read_text(const std::string& path);

/// Throws InvalidInput, with the place, when `text` holds a zero byte or invalid UTF-8; `name` says what it is.
void require_text(std::string_view text, const std::string& name);

}  // namespace eliminant::io
