// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <eliminant/numeric/cylinder_through_points.hpp>

namespace {

using eliminant::numeric::AtMostSix;
using eliminant::numeric::cross_product;
using eliminant::numeric::Cylinder;
using eliminant::numeric::dot_product;
using eliminant::numeric::real_cylinders_through;
using eliminant::numeric::SpaceVector;
using Points = std::array<SpaceVector<double>, 5>;

/// The largest distance of a point from the cylinder, over its radius.
double relative_distance(const Cylinder& cylinder, const Points& points) {
  double worst = 0;
  for (const SpaceVector<double>& point : points) {
    SpaceVector<double> difference{};
    for (std::size_t i = 0; i < 3; ++i) difference[i] = point[i] - cylinder.axis_point[i];
    const SpaceVector<double> moment = cross_product(difference, cylinder.direction);
    worst = std::max(worst, std::fabs(std::sqrt(dot_product(moment, moment)) / cylinder.radius - 1));
  }
  return worst;
}

}  // namespace

TEST_CASE("Cylinders through points: as many real ones through the 1000 random sets as exact arithmetic counts") {
  std::ifstream file(ELIMINANT_TEST_DATA "/cylinders/random_points.txt");
  std::map<std::size_t, int> histogram;
  std::size_t count = 0;
  Points points{};
  while (file >> count) {
    for (SpaceVector<double>& point : points)
      for (double& coordinate : point) file >> coordinate;
    const AtMostSix<Cylinder> cylinders = real_cylinders_through(points);
    CHECK(cylinders.size() == count);
    for (const Cylinder& cylinder : cylinders) CHECK(relative_distance(cylinder, points) < 1e-12);
    ++histogram[cylinders.size()];
  }
  CHECK(histogram == std::map<std::size_t, int>{{0, 213}, {2, 543}, {4, 225}, {6, 19}});
}

TEST_CASE("Cylinders through points: six of the same radius through the special five") {
  const Points points{{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {4.0 / 3, -1.0 / 3, -1.0 / 3}}};
  const AtMostSix<Cylinder> cylinders = real_cylinders_through(points);
  REQUIRE(cylinders.size() == 6);
  bool found = false;
  for (const Cylinder& cylinder : cylinders) {
    CHECK(cylinder.radius * cylinder.radius == doctest::Approx(0.54).epsilon(1e-14));
    const SpaceVector<double> difference = cross_product(cylinder.direction, SpaceVector<double>{0, 2, 1});
    found = found || dot_product(difference, difference) < 1e-28;
  }
  CHECK(found);
}

TEST_CASE("Cylinders through points: two points on one ruling") {
  // Rulings of the cylinder of radius 5 about the z-axis through (3, 4), (5, 0), (-4, 3), (0, -5).
  const Points points{{{3, 4, 0}, {3, 4, 7}, {5, 0, 1}, {-4, 3, 2}, {0, -5, -3}}};
  bool found = false;
  for (const Cylinder& cylinder : real_cylinders_through(points))
    found = found || (std::fabs(cylinder.radius - 5) < 1e-12 && std::fabs(cylinder.direction[2] - 1) < 1e-12);
  CHECK(found);
}

TEST_CASE("Cylinders through points: nothing that is no number through coplanar, collinear and repeated points") {
  const std::vector<Points> families{
      {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {{{0, 0, 0}, {1, 0, 0}, {3, 1, 0}, {0, 1, 0}, {5, 2, 0}}},
  };
  for (const Points& points : families)
    for (const Cylinder& cylinder : real_cylinders_through(points)) CHECK(std::isfinite(cylinder.radius));
}
