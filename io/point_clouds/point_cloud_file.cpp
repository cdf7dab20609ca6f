// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/point_clouds/point_cloud_file.hpp>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include <eliminant/base/error.hpp>
#include <eliminant/io/point_clouds/pcd_file.hpp>
#include <eliminant/io/point_clouds/ply_file.hpp>
#include <eliminant/io/point_clouds/point_cloud_text.hpp>

namespace eliminant::io {

namespace {

constexpr std::size_t most_bytes = std::size_t{8} << 30U;
constexpr std::size_t most_points = 100000000;
constexpr const char* expected_file = "a point cloud: XYZ, CSV, PLY or PCD";

/// A pipe without a writer never opens, and a device may never end. Standard input is what the caller meant.
void refuse_others_than_files(const std::string& path) {
  if (path == "/dev/stdin") return;
  std::error_code error;
  switch (std::filesystem::status(path, error).type()) {
    case std::filesystem::file_type::directory:
      throw InvalidInput("is a directory", expected_file);
    case std::filesystem::file_type::fifo:
    case std::filesystem::file_type::socket:
      throw InvalidInput("is a pipe or a socket", "a regular file or /dev/stdin");
    case std::filesystem::file_type::character:
    case std::filesystem::file_type::block:
      throw InvalidInput("is a device", "a regular file or /dev/stdin");
    default:
      return;
  }
}

std::string read_bytes(const std::string& path) {
  refuse_others_than_files(path);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw InvalidInput("cannot be opened: " + std::string(std::strerror(errno)), expected_file);
  std::string bytes;
  std::array<char, 65536> block{};
  while (true) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), file.get());
    bytes.append(block.data(), count);
    if (bytes.size() > most_bytes) throw LimitReached("is larger than 8 GiB, which is the limit");
    if (count < block.size()) break;
  }
  if (std::ferror(file.get()) != 0)
    throw InvalidInput("cannot be read: " + std::string(std::strerror(errno)), expected_file);
  return bytes;
}

}  // namespace

void PointCloud::add(const std::array<double, 3>& point) {
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2])) {
    ++dropped;
    return;
  }
  if (points.size() == most_points) throw LimitReached("there are more than 10^8 points, which is the limit");
  points.push_back(point);
}

CloudFormat cloud_format(std::string_view bytes) {
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return CloudFormat::ply;
  if (bytes.starts_with("# .PCD") || bytes.starts_with("VERSION ")) return CloudFormat::pcd;
  return CloudFormat::text;
}

PointCloud read_point_cloud(std::string_view bytes) {
  switch (cloud_format(bytes)) {
    case CloudFormat::ply:
      return read_ply(bytes);
    case CloudFormat::pcd:
      return read_pcd(bytes);
    case CloudFormat::text:
      break;
  }
  return read_text_cloud(bytes);
}

PointCloud read_point_cloud_file(const std::string& path) {
  const std::string name = "the cloud '" + path + "'";
  const auto with_name = [&](const std::string& message) {
    return name + (message.starts_with("is ") || message.starts_with("cannot ") ? " " : ": ") + message;
  };
  try {
    return read_point_cloud(read_bytes(path));
  } catch (const InvalidInput& error) {
    throw InvalidInput(with_name(error.what()), error.expected());
  } catch (const LimitReached& limit) {
    throw LimitReached(with_name(limit.what()));
  }
}

void refuse_cloud_line(std::size_t line, const std::string& problem, const std::string& expected) {
  throw InvalidInput("line " + std::to_string(line) + ": " + problem, expected, {line, 0});
}

void refuse_cloud_byte(std::size_t offset, const std::string& problem, const std::string& expected) {
  throw InvalidInput("byte " + std::to_string(offset) + ": " + problem, expected);
}

}  // namespace eliminant::io
