// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/bridge/contacts/height_ridge.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

using namespace eliminant::bridge;
using eliminant::symbolic::Rational;

TEST_CASE("Height ridge: where h_y vanishes, and h along it") {
  // 3 (y - x^2 + 2 x^3)^2 + 5 x^5: the ridge is y = x^2 - 2 x^3.
  PlaneSeries<Rational, 6> h;
  h.at(0, 2) = 3;
  h.at(2, 1) = -6;
  h.at(3, 1) = 12;
  h.at(4, 0) = 3;
  h.at(5, 0) = -12 + 5;
  h.at(6, 0) = 12;
  const auto ridge = height_ridge(h, 3);
  CHECK(ridge == std::vector<Rational>{0, 0, 1, -2});
  CHECK(height_along(h, ridge, 6) == std::vector<Rational>{0, 0, 0, 0, 0, 5, 0});
}

TEST_CASE("Height ridge: of higher terms in y, too") {
  // y^2 + x y + y^3: h_y = 2 y + x + 3 y^2, so y = -x / 2 - 3 x^2 / 8 - 9 x^3 / 16 - ...
  PlaneSeries<Rational> h;
  h.at(0, 2) = 1;
  h.at(1, 1) = 1;
  h.at(0, 3) = 1;
  const auto ridge = height_ridge(h, 3);
  const auto ratio = [](long p, long q) { return Rational(p) / Rational(q); };
  CHECK(ridge == std::vector<Rational>{0, ratio(-1, 2), ratio(-3, 8), ratio(-9, 16)});
  const auto along = height_along(h, ridge, 3);
  CHECK(along == std::vector<Rational>{0, 0, ratio(-1, 4), ratio(-1, 8)});
}

TEST_CASE("Height ridge: powers of a series") {
  const auto powers = powers_of(std::vector<Rational>{0, 1, 2}, 3, 4);
  CHECK(powers[0] == std::vector<Rational>{1, 0, 0, 0, 0});
  CHECK(powers[1] == std::vector<Rational>{0, 1, 2, 0, 0});
  CHECK(powers[2] == std::vector<Rational>{0, 0, 1, 4, 4});
  CHECK(powers[3] == std::vector<Rational>{0, 0, 0, 1, 6});
}
