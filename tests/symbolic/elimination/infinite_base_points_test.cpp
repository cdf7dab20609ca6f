// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <support/text_surfaces.hpp>

#include <eliminant/symbolic/elimination/infinite_base_points.hpp>

using namespace eliminant::symbolic;
using eliminant::test::map_of;

TEST_CASE("Infinite base points: planes, graphs and Enneper's surface go to infinity with their parameters") {
  const std::vector<std::vector<std::string>> maps{
      // (a, b, 0), (a, b, a^3 - 3 a b^2) at a = 1/u, b = 1/v.
      {"v", "u", "0", "u*v"},
      {"u^2*v^2", "u^3*v", "v^2 - 3*u^2", "u^3*v^2"},
      // (3 a - a^3 + 3 a b^2, 3 b - b^3 + 3 a^2 b, 3 a^2 - 3 b^2).
      {"3*u^2*v^3 - v^3 + 3*u^2*v", "3*u^3*v^2 - u^3 + 3*u*v^2", "3*u*v^3 - 3*u^3*v", "3*u^3*v^3"},
      // Not polynomial, but the first coordinate is 1/u.
      {"1 + v^2", "u*v^2", "u*v", "u + u*v^2"}};
  for (const auto& map : maps) {
    CAPTURE(map[0]);
    CHECK(is_infinite_around_origin(map_of(map)));
  }
}

TEST_CASE("Infinite base points: what stays finite along some path is not said to be infinite") {
  const std::vector<std::vector<std::string>> maps{
      // (u : v : u + v : u + v^2) on u = 2 v.
      {"u", "v", "u + v", "u + v^2"},
      // (a - b, a^2 - b^2, a^3 - b^3) on a = b.
      {"u^2*v^3 - u^3*v^2", "u*v^3 - u^3*v", "v^3 - u^3", "u^3*v^3"},
      // The pole of a sphere.
      {"2*u*v^2", "2*u^2*v", "v^2 + u^2 - u^2*v^2", "v^2 + u^2 + u^2*v^2"},
  };
  for (const auto& map : maps) {
    CAPTURE(map[0]);
    CHECK_FALSE(is_infinite_around_origin(map_of(map)));
  }
}
