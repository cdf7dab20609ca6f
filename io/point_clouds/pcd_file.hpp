// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include <eliminant/io/point_clouds/point_cloud_file.hpp>

namespace eliminant::io {

/// The points of a PCD file, versions 0.6 and 0.7: ASCII and binary (little-endian); fields besides x, y and z are
/// skipped. Throws InvalidInput with the line or byte, also for compressed files.
PointCloud read_pcd(std::string_view bytes);

}  // namespace eliminant::io
