// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/io/pictures/picture.hpp>

namespace eliminant::io {

/// The picture and its tables as one HTML page that needs no other file.
std::string html_report(const Picture& picture);

}  // namespace eliminant::io
