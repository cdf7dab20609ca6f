// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <eliminant/base/error.hpp>
#include <eliminant/io/point_clouds/ply_file.hpp>
#include <eliminant/io/point_clouds/point_cloud_file.hpp>
#include <filesystem>
#include <string>
#include <vector>

using namespace eliminant;
using namespace eliminant::io;

namespace {

using Points = std::vector<std::array<double, 3>>;

const Points two{{1, 2, 3}, {-4.5, 0, 1e-3}};

Points points_of(const std::string& bytes) { return read_point_cloud(bytes).points; }

std::string refusal(const std::string& bytes) {
  try {
    read_point_cloud(bytes);
  } catch (const InvalidInput& error) {
    CHECK(!error.expected().empty());
    return error.what();
  }
  return "accepted";
}

bool refused(const std::string& bytes, const std::string& part) {
  const std::string message = refusal(bytes);
  CAPTURE(message);
  return message.find(part) != std::string::npos;
}

template <class Number>
std::string bytes_of(Number number, bool big_endian) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return {bytes.begin(), bytes.end()};
}

std::string binary_ply(bool big_endian) {
  std::string out = std::string("ply\nformat ") + (big_endian ? "binary_big_endian" : "binary_little_endian") +
                    " 1.0\ncomment made by hand\nelement face 1\nproperty list uchar int vertex_indices\n"
                    "element vertex 2\nproperty uchar red\nproperty double x\nproperty float y\nproperty short z\n"
                    "end_header\n";
  out += bytes_of<std::uint8_t>(2, big_endian) + bytes_of<std::int32_t>(7, big_endian) +
         bytes_of<std::int32_t>(8, big_endian);
  out += bytes_of<std::uint8_t>(255, big_endian) + bytes_of(1.25, big_endian) + bytes_of(-2.5F, big_endian) +
         bytes_of<std::int16_t>(-3, big_endian);
  out += bytes_of<std::uint8_t>(0, big_endian) + bytes_of(1e100, big_endian) + bytes_of(0.5F, big_endian) +
         bytes_of<std::int16_t>(300, big_endian);
  return out;
}

std::string pcd_header(const std::string& data, const std::string& points) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 8 2\n"
         "TYPE F F F U\nCOUNT 1 1 1 2\nWIDTH " +
         points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA " + data + "\n";
}

}  // namespace

TEST_CASE("XYZ: blanks, tabs, comments, a count, further columns, all ends of line") {
  CHECK(points_of("1 2 3\n-4.5 0 1e-3\n") == two);
  CHECK(points_of("  1\t2 3 0.5 0.5\r\n\r\n# a comment\n// another\n-4.50 +0 .001") == two);
  CHECK(points_of("2\n1 2 3\n-4.5 0 1e-3\n") == two);
  CHECK(points_of("2\r1 2 3\r# a comment\r-4.5 0 1e-3\r") == two);
}

TEST_CASE("CSV: commas, semicolons, names of columns in any order, quotes, a byte order mark") {
  CHECK(points_of("1,2,3\n-4.5,0,1e-3\n") == two);
  CHECK(points_of("\xEF\xBB\xBFz;name;\"X\";Y\n3;a b;1;2\n0.001;\"c\";-4.5;0\n") == two);
  CHECK(points_of("x y z\n1 2 3\n-4.5 0 0.001\n") == two);
  CHECK(points_of("x\ty\tz\n1\t2\t3\n-4.5\t0\t0.001\n") == two);
}

TEST_CASE("Points that are not finite are left out and counted") {
  const PointCloud cloud = read_point_cloud("1 2 3\nnan 0 0\n0 inf 0\n-4.5 0 1e-3\n0 0 -inf\n0 0 NaN\n");
  CHECK(cloud.points == two);
  CHECK(cloud.dropped == 4);
}

TEST_CASE("XYZ and CSV: what is wrong is named with its line") {
  CHECK(refused("1 2 3\n1 2\n", "line 2: there are only 2 fields, z is missing"));
  CHECK(refused("1 2 3\n\n1 two 3\n", "line 3: y is 'two'"));
  CHECK(refused("1,2,3\n1,,3\n", "line 2: y is ''"));
  CHECK(refused("3\n1 2 3\n4 5 6\n", "the first line says 3 points, and 2 follow"));
  CHECK(refused("0x1.8p1 0x2p0 0x3p0\n", "line 1: there is no number: '0x1.8p1'"));
  CHECK(refused("1 2 1e999\n", "line 1: z is '1e999'"));
  CHECK(refused("x,y,intensity\n1,2,3\n", "line 1: there is no column z"));
  CHECK(refused("", "no points"));
  CHECK(refused("# nothing\n\n", "no points"));
  CHECK(refused(std::string("1 2 3\n\0 1 2\n", 12), "line 2: a zero byte"));
  CHECK(refused(std::string("1 2 3\n1 \0002 3\n", 13), "line 2: a zero byte"));
  CHECK(refused("x,y,x,z\n1,2,3,4\n", "line 1: there are two columns x among the names 'x,y,x,z'"));
  CHECK(refused("x y Z z\n1 2 3 4\n", "line 1: there are two columns z"));
  CHECK(refused("0x10 1 2\n1 2 3\n", "line 1"));
  CHECK(points_of("1e-999 0 0\n") == Points{{0, 0, 0}});
}

TEST_CASE("PLY: ASCII, properties in any order, elements before and after the vertices") {
  CHECK(points_of("ply\nformat ascii 1.0\nelement camera 1\nproperty float f\nelement vertex 2\nproperty float z\n"
                  "property list uchar int tags\nproperty double x\nproperty float y\nelement face 1\n"
                  "property list uchar int vertex_indices\nend_header\n50\n3 2 8 9 1 2\n0.001 0 -4.5 0\n3 0 1 0\n") ==
        two);
  CHECK(points_of("ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty float x\r\nproperty float y\r\n"
                  "property float z\r\nend_header\r\n1 2 3\r\n") == Points{{1, 2, 3}});
  CHECK(points_of("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                  "end_header\n")
            .empty());
}

TEST_CASE("PLY: binary in both byte orders, with types of all sizes and a list to skip") {
  const Points expected{{1.25, -2.5, -3}, {1e100, 0.5, 300}};
  CHECK(points_of(binary_ply(false)) == expected);
  CHECK(points_of(binary_ply(true)) == expected);
}

TEST_CASE("PLY: every file that ends too early is refused with the byte where it ends") {
  for (const bool big_endian : {false, true}) {
    const std::string whole = binary_ply(big_endian);
    const std::size_t header = whole.find("end_header\n") + 11;
    for (std::size_t length = header; length < whole.size(); ++length)
      CHECK(refused(whole.substr(0, length), "byte " + std::to_string(length) + ": the file ends inside"));
    for (std::size_t length = 4; length < header - 11; ++length) CHECK(refusal(whole.substr(0, length)) != "accepted");
  }
}

TEST_CASE("PLY: headers that promise or name the wrong things") {
  const std::string begin = "ply\nformat ascii 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\nend_header\n";
  CHECK(refused(begin + "element vertex 99999999999\n" + xyz + "1 2 3\n", "line 8: the file ends after 1 of"));
  CHECK(refused("ply\nformat binary_little_endian 1.0\nelement vertex 99999999999\n" + xyz + "abc",
                "the file ends inside"));
  CHECK(refused(begin + "element vertex -1\n" + xyz, "line 3: the number of elements 'vertex' is '-1'"));
  CHECK(refused(begin + "element vertex\n" + xyz, "line 3: an element without its name and number"));
  CHECK(refused(begin + "element vertex 1\nproperty double x\n" + xyz + "1 2 3 4\n",
                "line 5: there is a second property x of 'vertex'"));
  CHECK(refused(begin + "element vertex 1\nproperty float x\nelement vertex 1\n" + xyz,
                "line 5: there is a second element 'vertex'"));
  CHECK(refused(begin + "element vertex 1\n" + xyz + std::string("1 2\0 3\n", 7), "line 8: y is '2?'"));
  CHECK(refused(begin + "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n", "no property z"));
  CHECK(refused(begin + "element vertex 1\nproperty quad x\n", "line 4: unknown type 'quad'"));
  CHECK(refused(begin + "property float x\n", "line 3: a property that belongs to nothing"));
  CHECK(refused(begin + "element face 1\n" + xyz + "1 2 3\n", "no element vertex"));
  CHECK(refused(begin + "element vertex 1\n" + xyz + "1 2\n", "line 8: the property z is missing"));
  CHECK(refused(begin + "element vertex 1\n" + xyz + "1 b 3\n", "line 8: y is 'b'"));
  CHECK(refused("ply\nformat ascii 2.0\n", "line 2: unknown format"));
  CHECK(refused("ply\nnonsense\n", "line 2: unknown word 'nonsense'"));
  CHECK(refused("ply\nelement vertex 1\n" + xyz, "names no format"));
  // A list longer than the file, of a length with a sign.
  std::string list = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty list int double t\n" + xyz;
  CHECK(refused(list + bytes_of<std::int32_t>(-1, false) + std::string(64, 'a'), "the file ends inside"));
  CHECK(refused(list + bytes_of<std::int32_t>(1 << 30, false) + std::string(64, 'a'), "the file ends inside"));
}

TEST_CASE("PLY: a binary body begins after the end of the header's last line, whatever its first byte") {
  for (const char* end : {"\n", "\r\n", "\r"})
    for (const char first : {'\n', '\r', ' '}) {
      std::string file;
      for (const char* line : {"ply", "format binary_little_endian 1.0", "element vertex 1", "property uchar red",
                               "property float x", "property float y", "property float z", "end_header"})
        file += std::string(line) + end;
      file += first + bytes_of(1.0F, false) + bytes_of(2.0F, false) + bytes_of(3.0F, false);
      CAPTURE(static_cast<int>(first));
      CHECK(points_of(file) == Points{{1, 2, 3}});
    }
}

TEST_CASE("PCD: ASCII and binary, fields of several values") {
  CHECK(points_of(pcd_header("ascii", "2") + "1 2 3 7 7\n-4.5 0 0.001 8 8\n") == two);
  std::string binary = pcd_header("binary", "2");
  for (const auto& [x, y, z] : {std::array{1.5, 2.0, 3.0}, std::array{-4.5, 0.0, 0.001}})
    binary +=
        bytes_of(static_cast<float>(x), false) + bytes_of(static_cast<float>(y), false) + bytes_of(z, false) + "abcd";
  CHECK(points_of(binary) == Points{{1.5, 2, 3}, {-4.5, 0, 0.001}});
  CHECK(refused(binary.substr(0, binary.size() - 1), "the file ends after 1 of 2 points"));
  CHECK(refused(pcd_header("ascii", "3") + "1 2 3 7 7\n-4.5 0 0.001 8 8\n", "line 13: the file ends after 2 of 3"));
  CHECK(refused(pcd_header("ascii", "1") + "1 2\n", "line 12: z is missing"));
  CHECK(refused(pcd_header("binary_compressed", "2"), "line 11: the data are 'binary_compressed'"));
  CHECK(refused(pcd_header("ascii", "many"), "accepted") == false);
  CHECK(refused("VERSION 0.7\nFIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 1\nDATA ascii\n1 2\n", "no field z"));
  CHECK(refused("VERSION 0.7\nFIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n", "as many entries"));
  CHECK(refused("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nPOINTS 1\nDATA ascii\n", "'F3'"));
  CHECK(refused("VERSION 0.7\nFIELDS x y z\n", "the header does not end"));
}

TEST_CASE("PCD: a header that contradicts itself is refused") {
  const auto header = [](const std::string& counts, const std::string& fields = "x y z") {
    return "VERSION 0.7\nFIELDS " + fields + "\nSIZE 4 4 4" + (fields.size() > 5 ? " 4" : "") + "\nTYPE F F F" +
           (fields.size() > 5 ? " F" : "") + "\n" + counts + "DATA ascii\n1 2 3 4\n";
  };
  CHECK(points_of(header("POINTS 1\n")) == Points{{1, 2, 3}});
  CHECK(points_of(header("WIDTH 1\nHEIGHT 1\n")) == Points{{1, 2, 3}});
  CHECK(points_of(header("WIDTH 1\nHEIGHT 1\nPOINTS 1\n")) == Points{{1, 2, 3}});
  CHECK(refused(header("WIDTH 10\nHEIGHT 1\nPOINTS 1\n"), "line 8: WIDTH 10 times HEIGHT 1 is not POINTS 1"));
  const std::string large = "WIDTH 4294967296\nHEIGHT 4294967296\n";
  CHECK(refused(header(large), "line 7: WIDTH 4294967296 times HEIGHT 4294967296 is too large"));
  CHECK(refused(header(large + "POINTS 0\n"), "is too large"));
  CHECK(refused(header("POINTS -1\n"), "line 6: POINTS is '-1'"));
  CHECK(refused(header("WIDTH 1 1\nHEIGHT 1\nPOINTS 1\n"), "WIDTH is '1'"));
  CHECK(refused(header("WIDTH 1\n"), "does not say how many points"));
  CHECK(refused(header("POINTS 1\nPOINTS 1\n"), "line 6: there is a second line 'POINTS'"));
  CHECK(refused(header("POINTS 1\n", "x y x z"), "there are two fields x"));
  // Fields that fill up may share a name.
  CHECK(points_of("VERSION 0.7\nFIELDS _ x y z _\nSIZE 1 4 4 4 1\nTYPE U F F F U\nPOINTS 1\nDATA ascii\n0 1 2 3 0\n") ==
        Points{{1, 2, 3}});
}

TEST_CASE("labelled_ply: read again it gives the same points") {
  const std::vector<std::int32_t> labels{-1, 3};
  const std::string ply = labelled_ply(two, labels);
  CHECK(points_of(ply) == two);
  CHECK(ply.substr(ply.size() - 4) == bytes_of<std::int32_t>(3, false));
  CHECK(ply.find("property int label\n") != std::string::npos);
  // Grey where there is no cylinder.
  const std::size_t first_color = ply.find("end_header\n") + 11 + 24;
  CHECK(ply.substr(first_color, 3) == "\x80\x80\x80");
  CHECK(ply.substr(first_color + 31, 3) != "\x80\x80\x80");
}

TEST_CASE("Files of clouds that cannot be read are named") {
  const auto message_of = [](const std::string& path) -> std::string {
    try {
      read_point_cloud_file(path);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  };
  CHECK(message_of("/nowhere/scan.ply").find("the cloud '/nowhere/scan.ply' cannot be opened") == 0);
  CHECK(message_of("/") == "the cloud '/' is a directory");
  CHECK(message_of("/dev/zero") == "the cloud '/dev/zero' is a device");
  // Nobody writes to it: to open it would be to wait for ever.
  const std::string pipe = std::filesystem::temp_directory_path() / ("eliminant-pipe-" + std::to_string(getpid()));
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const std::string message = message_of(pipe);
  std::filesystem::remove(pipe);
  CHECK(message == "the cloud '" + pipe + "' is a pipe or a socket");
}
