// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <support/text_surfaces.hpp>

#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/elimination/exceptional_points.hpp>

using namespace eliminant::symbolic;
using eliminant::test::map_of;

namespace {

Polynomial form(const std::string& text) {
  const std::vector<std::string> names{"x", "y", "z", "w"};
  return parse_polynomial(text, names);
}

}  // namespace

TEST_CASE("Exceptional points: the pole of a sphere and the apex of a cone are images of lines") {
  const RationalSurface sphere = map_of({"2*u", "2*v", "u^2 + v^2 - 1", "u^2 + v^2 + 1"});
  const Polynomial of_sphere = form("x^2 + y^2 + z^2 - w^2");
  CHECK(are_exceptions_contracted_lines(sphere, of_sphere, {form("w - z")}));
  CHECK(are_exceptions_contracted_lines(sphere, of_sphere, {form("(w - z)*w")}));
  const RationalSurface cone = map_of({"v*(1 - u^2)", "2*u*v", "v*(u^2 + 1)", "u^2 + 1"});
  const Polynomial of_cone = form("x^2 + y^2 - z^2");
  CHECK(are_exceptions_contracted_lines(cone, of_cone, {form("z*(x + z)"), form("z*(x - z)")}));
  // Moved and turned; the vertex is (1, 2, 3), the line v = 2.
  const RationalSurface moved = map_of(
      {"(v - 2)*(1 - u^2) + 1 + u^2", "(v - 2)*(u^2 + 1) + 2*(1 + u^2)", "2*u*(v - 2) + 3*(1 + u^2)", "u^2 + 1"});
  CHECK(are_exceptions_contracted_lines(moved, form("(x - w)^2 + (z - 3*w)^2 - (y - 2*w)^2"), {form("y - 2*w")}));
}

TEST_CASE("Exceptional points: lines of them, and points without parameters, are refused") {
  // A generator has no witness.
  const RationalSurface cone = map_of({"v*(1 - u^2)", "2*u*v", "v*(u^2 + 1)", "u^2 + 1"});
  CHECK_FALSE(are_exceptions_contracted_lines(cone, form("x^2 + y^2 - z^2"), {form("x - z")}));
  // A hyperboloid projected from a point: two lines through it are not covered.
  const RationalSurface hyperboloid = map_of({"2*u", "2*v", "u^2 - v^2 - 1", "u^2 - v^2 + 1"});
  CHECK_FALSE(are_exceptions_contracted_lines(hyperboloid, form("x^2 - y^2 + z^2 - w^2"), {form("w - z")}));
  // (0, 0, -1) has one pair of parameters, (0, 0), and (0, 0, 1) lines: told by the witness.
  const RationalSurface sphere = map_of({"2*u", "2*v", "u^2 + v^2 - 1", "u^2 + v^2 + 1"});
  CHECK_FALSE(are_exceptions_contracted_lines(sphere, form("x^2 + y^2 + z^2 - w^2"), {form("w + z")}));
  // Cubics are not looked at.
  CHECK_FALSE(are_exceptions_contracted_lines(map_of({"u", "v", "u^3", "1"}), form("z*w^2 - x^3"), {form("w")}));
}
