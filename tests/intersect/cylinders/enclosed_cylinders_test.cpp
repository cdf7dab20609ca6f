// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/cylinders/enclosed_cylinders.hpp>

using namespace eliminant;
using intersect::enclosed_real_cylinders;
using intersect::EnclosedCylinder;
using intersect::EnclosedCylinders;
using Points = std::array<std::array<double, 3>, 5>;

namespace {

/// Points on the cylinder of this radius about the z-axis, moved to `shift`; exact for such numbers.
Points on_cylinder(double shift) {
  Points points{{{3, 4, 0}, {-4, 3, 7}, {5, 0, 1}, {4, -3, 2}, {0, -5, -3}}};
  for (auto& point : points)
    for (double& coordinate : point) coordinate += shift;
  return points;
}

const EnclosedCylinder* upright(const EnclosedCylinders& result) {
  for (const EnclosedCylinder& cylinder : result.cylinders)
    if (std::fabs(cylinder.cylinder.direction[2] - 1) < 1e-6) return &cylinder;
  return nullptr;
}

}  // namespace

TEST_CASE("Enclosed cylinders: the random sets need no exact arithmetic") {
  std::ifstream file(ELIMINANT_TEST_DATA "/cylinders/random_points.txt");
  std::size_t count = 0;
  Points points{};
  while (file >> count) {
    for (auto& point : points)
      for (double& coordinate : point) file >> coordinate;
    const EnclosedCylinders result = enclosed_real_cylinders(points);
    CHECK(result.status == intersect::Status::certified);
    CHECK(!result.exact);
    CHECK(result.cylinders.size() == count);
  }
}

TEST_CASE("Enclosed cylinders: true values are within the errors, which are small") {
  for (const double shift : {0.0, 1e6, -1048576.25}) {
    const EnclosedCylinders result = enclosed_real_cylinders(on_cylinder(shift));
    CHECK(result.status == intersect::Status::certified);
    const EnclosedCylinder* found = upright(result);
    REQUIRE(found != nullptr);
    CHECK(std::fabs(found->cylinder.radius - 5) <= found->radius_error);
    CHECK(found->radius_error < 1e-9);
    CHECK(std::fabs(found->cylinder.direction[0]) <= found->direction_error);
    CHECK(std::fabs(found->cylinder.direction[1]) <= found->direction_error);
    CHECK(found->direction_error < 1e-10);
    // The foot of the perpendicular from the first point.
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::fabs(found->cylinder.axis_point[i] - shift) <= found->axis_point_error);
    CHECK(found->axis_point_error < 1e-8);
  }
}

TEST_CASE("Enclosed cylinders: what doubles do not decide is decided exactly") {
  // Three points on the first ruling: its direction is double.
  const EnclosedCylinders doubled =
      enclosed_real_cylinders({{{3, 4, 0}, {3, 4, 7}, {3, 4, 9}, {-4, 3, 2}, {0, -5, -3}}});
  CHECK(doubled.status == intersect::Status::certified);
  CHECK(doubled.exact);
  const EnclosedCylinder* found = upright(doubled);
  REQUIRE(found != nullptr);
  CHECK(found->multiplicity == 2);
  CHECK(std::fabs(found->cylinder.radius - 5) <= found->radius_error);
  CHECK(std::fabs(found->cylinder.axis_point[0]) <= found->axis_point_error);
  CHECK(std::fabs(found->cylinder.axis_point[2]) <= found->axis_point_error);
  CHECK(found->radius_error < 1e-14);

  const EnclosedCylinders circle = enclosed_real_cylinders({{{5, 0, 0}, {-5, 0, 0}, {0, 5, 0}, {0, -5, 0}, {3, 4, 0}}});
  CHECK(circle.exact);
  REQUIRE(circle.cylinders.size() == 1);
  CHECK(circle.cylinders[0].multiplicity == 4);
  CHECK(circle.cylinders[0].cylinder.radius == 5);

  const EnclosedCylinders infinite = enclosed_real_cylinders({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 1}}});
  CHECK(infinite.status == intersect::Status::infinite);
  CHECK(infinite.cylinders.empty());
}

TEST_CASE("Enclosed cylinders: both ways agree on nearly degenerate points") {
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int exact = 0;
  for (int round = 0; round < 200; ++round) {
    // Five points of a plane moved out of it by ever less.
    const double height = std::ldexp(1.0, -round / 3);
    Points points{};
    for (auto& point : points) point = {uniform(generator), uniform(generator), height * uniform(generator)};
    const EnclosedCylinders result = enclosed_real_cylinders(points);
    CHECK(result.status == intersect::Status::certified);
    exact += result.exact ? 1 : 0;
    for (const EnclosedCylinder& cylinder : result.cylinders) {
      CHECK(cylinder.direction_error <= 1e-6);
      CHECK(cylinder.radius_error <= 1e-6 * cylinder.cylinder.radius);
    }
    Points turned{};
    for (std::size_t k = 0; k < 5; ++k) turned[k] = points[(2 * k + 1) % 5];
    CHECK(enclosed_real_cylinders(turned).cylinders.size() == result.cylinders.size());
  }
  // The ladder was used on both rungs.
  CHECK(exact > 0);
  CHECK(exact < 200);
}

TEST_CASE("Enclosed cylinders: numbers that are not finite are refused") {
  Points points = on_cylinder(0);
  points[3][1] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH_AS(enclosed_real_cylinders(points), "a coordinate of point 4 is not finite", InvalidInput);
  points[3][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(enclosed_real_cylinders(points), InvalidInput);
}
