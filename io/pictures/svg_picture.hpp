// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/io/pictures/picture.hpp>

namespace eliminant::io {

/// The picture as SVG 1.1: panels side by side, with ticks, borders and a legend; the same bytes for the same picture.
/// Where a panel has no border, it shows where most of the points are: branches run out of it to infinity.
std::string svg_picture(const Picture& picture);

/// Text between tags: without characters that XML gives a meaning, or does not have.
std::string escaped(const std::string& text);

}  // namespace eliminant::io
