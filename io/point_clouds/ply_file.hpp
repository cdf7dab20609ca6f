// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <eliminant/io/point_clouds/point_cloud_file.hpp>

namespace eliminant::io {

/// The vertices of a PLY file, version 1.0: ASCII and binary of both byte orders, x, y and z of any type of number;
/// other elements and properties, lists among them, are skipped. Throws InvalidInput with the line or byte; the numbers
/// of a header are believed only as far as the file is long.
PointCloud read_ply(std::string_view bytes);

/// Points as a PLY file (binary, little-endian): x, y, z as doubles, a color for each label and the label itself, -1
/// for points without one in grey. As many labels as points.
std::string labelled_ply(std::span<const std::array<double, 3>> points, std::span<const std::int32_t> labels);

}  // namespace eliminant::io
