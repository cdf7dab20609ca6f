// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <string>

#include <support/text_surfaces.hpp>

#include <eliminant/symbolic/elimination/space_curve_germ.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using test::in_space;

namespace {

/// x = (a + 8 b - 4 c) / 9, ...: coordinates in which no axis is special.
Polynomial turned(const std::string& text) {
  const std::array<Polynomial, 3> frame{in_space("x + 8*y - 4*z"), in_space("4*x - 4*y - 7*z"),
                                        in_space("8*x + y + 4*z")};
  return in_space(text).compose(frame);
}

bool is_singular(const Polynomial& f, const Polynomial& g) {
  return is_singular_at_origin(f, g, {projected_curve(f, g, 0), projected_curve(f, g, 1), projected_curve(f, g, 2)});
}

}  // namespace

TEST_CASE("projected curve: components are simple, and all common zeros are above it") {
  // The unit circle in the plane y = z, twice: along z an ellipse.
  const auto ellipse = projected_curve(in_space("x^2 + y^2 + z^2 - 1"), in_space("(y - z)^2"), 2);
  REQUIRE(ellipse);
  CHECK((*ellipse == in_space("x^2 + 2*y^2 - 1") || *ellipse == in_space("1 - x^2 - 2*y^2")));
}

TEST_CASE("projected curve: common zeros at infinity and common components are refused") {
  CHECK_FALSE(projected_curve(in_space("x*z - 1"), in_space("x^2 + y^2 + z^2 - 1"), 2));
  CHECK_FALSE(projected_curve(in_space("z*(x + z)"), in_space("z*(y + z)"), 2));
}

TEST_CASE("space curve germ: smooth ones are not singular") {
  CHECK_FALSE(is_singular(turned("x^2 + y^2 + z^2 - 2*z"), turned("x + z")));
  // A circle of contact, and a line of contact through the apex of a cone.
  CHECK_FALSE(is_singular(turned("x^2 + y^2 + z^2 - 2*z"), turned("(x + z)^2")));
  CHECK_FALSE(is_singular(turned("x^2 + y^2 - z^2"), turned("x - z")));
  // The origin is not on the curve.
  CHECK_FALSE(is_singular(turned("x^2 + y^2 - z^2"), turned("x - z - 1")));
}

TEST_CASE("space curve germ: cusps, crossings and points on their own are singular") {
  CHECK(is_singular(turned("z - x^2 - y^2"), turned("y*z - x^2")));
  CHECK(is_singular(turned("z - x^2 - y^2"), turned("z - 3*y^2")));
  CHECK(is_singular(turned("x^2 + y^2 - z^2"), turned("y")));
  CHECK(is_singular(turned("z - x^2 - y^2"), turned("z")));
}

TEST_CASE("space curve germ: another point of the curve on the axis proves nothing") {
  // A smooth arc of the circle and, above it, that at its other pole: both projections along z are one conic.
  CHECK_FALSE(is_singular(in_space("x^2 + y^2 + z^2 - 2*z"), in_space("x*(x + y + z - 2)")));
}
