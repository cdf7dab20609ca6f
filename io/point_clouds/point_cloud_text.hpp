// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include <eliminant/io/point_clouds/point_cloud_file.hpp>

namespace eliminant::io {

/// Points as lines of numbers between blanks (XYZ), commas, semicolons or tabs (CSV); what separates is told by the
/// first line with numbers. x, y and z are the first three, or the columns of these names where the first line has
/// names; further columns are ignored. Empty lines and comments (`#`, `//`) are skipped, and so is a first line with
/// nothing but the number of points, which has to be right. Throws InvalidInput with the line.
PointCloud read_text_cloud(std::string_view text);

}  // namespace eliminant::io
