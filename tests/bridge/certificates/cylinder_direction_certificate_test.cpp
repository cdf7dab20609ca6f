// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <vector>

#include <eliminant/bridge/certificates/cylinder_direction_certificate.hpp>

using namespace eliminant::bridge;
using Points = std::array<std::array<double, 3>, 5>;

namespace {

std::optional<CertifiedDirections> certified(const Points& points) {
  return certify_cylinder_directions(scaled_offsets(points));
}

const Points on_ruling{{{3, 4, 0}, {3, 4, 7}, {5, 0, 1}, {-4, 3, 2}, {0, -5, -3}}};

}  // namespace

TEST_CASE("Cylinder directions: six are proven of every random set, as many of them real as there are") {
  std::ifstream file(ELIMINANT_TEST_DATA "/cylinders/random_points.txt");
  std::size_t count = 0;
  std::size_t sets = 0;
  Points points{};
  while (file >> count) {
    for (auto& point : points)
      for (double& coordinate : point) file >> coordinate;
    ++sets;
    const auto directions = certified(points);
    REQUIRE(directions);
    std::size_t real = 0;
    for (const CertifiedDirection& direction : *directions) real += direction.real ? 1 : 0;
    CHECK(real == count);
    CHECK(2 * directions->size() - real == 6);
  }
  CHECK(sets == 1000);
}

TEST_CASE("Cylinder directions: a planted direction and its axis lie in their enclosures") {
  const ScaledOffsets offsets = scaled_offsets(on_ruling);
  const auto directions = certify_cylinder_directions(offsets);
  REQUIRE(directions);
  int found = 0;
  for (const CertifiedDirection& direction : *directions) {
    if (!direction.real || std::abs(direction.center[0]) > direction.radius ||
        std::abs(direction.center[1]) > direction.radius)
      continue;
    ++found;
    CHECK(direction.pivot == 2);
    const EnclosedAxis axis = enclose_axis(offsets, direction);
    const double scale = std::ldexp(1.0, offsets.scale_log2);
    // The axis is the z-axis, the first point (3, 4, 0).
    CHECK(axis.offset[0].lower * scale <= -3);
    CHECK(axis.offset[0].upper * scale >= -3);
    CHECK(axis.offset[1].lower * scale <= -4);
    CHECK(axis.offset[1].upper * scale >= -4);
    CHECK(axis.radius_squared.lower * scale * scale <= 25);
    CHECK(axis.radius_squared.upper * scale * scale >= 25);
    CHECK(axis.radius_squared.upper - axis.radius_squared.lower < 1e-9);
  }
  CHECK(found == 1);
}

TEST_CASE("Cylinder directions: nothing is proven of double directions and of points that span no space") {
  // Three points on a ruling, where the direction is double; coplanar points; equal points.
  CHECK(!certified({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 2}, {1, 5, 7}}}));
  CHECK(!certified({{{5, 0, 0}, {-5, 0, 0}, {0, 3, 0}, {0, -3, 0}, {3, 2, 0}}}));
  CHECK(!certified({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}));
  CHECK(!certified({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}));
}

TEST_CASE("Cylinder directions: numbers out of range prove nothing") {
  const auto scaled = [](double factor) {
    Points points = on_ruling;
    for (auto& point : points)
      for (double& coordinate : point) coordinate *= factor;
    return certified(points);
  };
  CHECK(scaled(0x1p800));
  CHECK(scaled(0x1p-800));
  CHECK(!scaled(0x1p1020));
  CHECK(!scaled(std::numeric_limits<double>::denorm_min()));
  // Points that a flat map takes nearly into a plane.
  Points flat = on_ruling;
  for (auto& point : flat) point[2] *= 0x1p-300;
  CHECK(!certified(flat));
  Points points = on_ruling;
  points[2][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(!certified(points));
  points[2][1] = std::numeric_limits<double>::infinity();
  CHECK(!certified(points));
}
