// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::io {

/// The points of a cloud with finite coordinates, in the order of the file.
struct PointCloud {
  std::vector<std::array<double, 3>> points;
  /// Points of the file that are not finite, which are left out: scanners write them where nothing came back.
  std::size_t dropped = 0;

  /// Keeps the point, or counts it as dropped.
  void add(const std::array<double, 3>& point);
};

/// What a cloud in the memory is read as.
enum class CloudFormat { text, ply, pcd };

/// By the first bytes: "ply" and "# .PCD" or "VERSION" begin these formats, everything else is text.
CloudFormat cloud_format(std::string_view bytes);

/// Reads the points of a cloud; only x, y and z are looked at. Throws InvalidInput, whose message begins with the line
/// or byte and whose place has the line where there is one, and LimitReached for more than 10^8 points.
PointCloud read_point_cloud(std::string_view bytes);

/// The same for a file. Throws InvalidInput for a file that cannot be read, and LimitReached for more than 8 GiB; all
/// messages name the file.
PointCloud read_point_cloud_file(const std::string& path);

/// Refuses part of a cloud.
[[noreturn]] void refuse_cloud_line(std::size_t line, const std::string& problem, const std::string& expected);
[[noreturn]] void refuse_cloud_byte(std::size_t offset, const std::string& problem, const std::string& expected);

}  // namespace eliminant::io
