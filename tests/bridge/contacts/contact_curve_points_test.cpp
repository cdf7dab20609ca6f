// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/contact_curve_points.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

TEST_CASE("Contact curve points: on the curve from border to border, over a branch that crosses it") {
  const NetPair nets({"u", "v", "u*v"}, {"v", "u", "u*v + (v - u^2 - 1/4)^2*(u - v/3)"});
  const auto start = contact_curve_point(nets.first, nets.second, {0.4, 0.4, 0.42, 0.41}, 0.1);
  REQUIRE(start);
  const auto points = contact_curve_points(nets.first, nets.second, *start);
  CHECK(points.size() >= 24);
  double least = 1;
  double most = 0;
  for (const std::array<double, 4>& at : points) {
    // The second patch has its parameters exchanged.
    CHECK(std::fabs(at[0] - at[3]) < 1e-9);
    CHECK(std::fabs(at[1] - at[2]) < 1e-9);
    CHECK(std::fabs(at[3] - at[2] * at[2] - 0.25) < 1e-9);
    least = std::min(least, at[2]);
    most = std::max(most, at[2]);
  }
  CHECK(least < 0.05);
  CHECK(most > 0.8);
}

TEST_CASE("Contact curve points: none near a contact on its own, a crossing and parallel planes apart") {
  for (const std::string height : {"(u - 1/2)^2 + (v - 1/2)^2", "(u - 1/2)^2 - (v - 1/2)^2", "(u - 1/2)^2 + 1/1000"}) {
    CAPTURE(height);
    const NetPair nets({"u", "v", "0"}, {"u", "v", height});
    CHECK_FALSE(contact_curve_point(nets.first, nets.second, {0.51, 0.49, 0.51, 0.49}, 0.1));
  }
}

TEST_CASE("Contact curve points: along a border that lies in the other patch, with that one's parameters") {
  // The border u = 1 from v = 1/4 to 3/4 is the border s = 0, with v = 3/4 - t/2.
  const NetPair nets({"u", "v", "u^2"}, {"1 + u", "3/4 - v/2", "1 + 2*u - 3*u^2"});
  const auto of_first = points_along_border(nets.first, nets.second, {0, 1, 0.25, 0.75});
  const auto of_second = points_along_border(nets.first, nets.second, {2, -1, 0, 1});
  for (const auto& points : {of_first, of_second}) {
    CHECK(points.size() >= 24);
    for (const std::array<double, 4>& at : points) {
      CHECK(at[0] == doctest::Approx(1));
      CHECK(std::fabs(at[2]) < 1e-12);
      CHECK(std::fabs(at[1] - 0.75 + at[3] / 2) < 1e-12);
    }
  }
  CHECK(points_along_border(nets.first, nets.second, {0, -1, 0, 1}).empty());
}
