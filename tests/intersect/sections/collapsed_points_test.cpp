// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <support/text_surfaces.hpp>

#include <eliminant/intersect/patches/surface_surface.hpp>

using namespace eliminant;
using intersect::Options;
using intersect::Status;
using intersect::SurfaceComponentKind;
using intersect::SurfaceResult;
using intersect::SurfaceSingularity;
using test::cone;
using test::in_space;
using test::map_of;
using test::sphere_by_angles;
using test::sphere_from_pole;
using test::Texts;

namespace {

/// By the distance from the axis and the height at v: every point has two pairs of parameters where the one is odd and
/// the other even.
Texts revolution(const std::string& radius, const std::string& height) {
  return {"(" + radius + ")*(1 - u^2)", "(" + radius + ")*2*u", "(" + height + ")*(1 + u^2)", "1 + u^2"};
}

SurfaceResult section(const Texts& map, const std::string& equation) {
  Options options;
  options.tolerance = 1e-6;
  return intersect_surface_surface({symbolic::ParametricSurface{{{map_of(map), std::nullopt}}}, in_space(equation)},
                                   options, Context());
}

void check_loops(const SurfaceResult& result, std::size_t count, bool tangential) {
  CHECK(result.status == Status::certified);
  CHECK(result.singular_points.empty());
  CHECK(result.components.size() == count);
  for (const auto& component : result.components) {
    CHECK(component.kind == SurfaceComponentKind::loop);
    CHECK(component.tangential == tangential);
  }
}

void check_singular(const SurfaceResult& result, SurfaceSingularity kind, std::size_t half_branches) {
  CHECK(result.status == Status::certified);
  REQUIRE(result.singular_points.size() == 1);
  const auto& point = result.singular_points.front();
  CHECK(point.kind == kind);
  CHECK(point.half_branches == half_branches);
  CHECK(point.certified);
}

}  // namespace

TEST_CASE("collapsed points: curves of contact go on through a pole") {
  // The ellipsoid touches the sphere along a great circle through both poles.
  check_loops(section(sphere_by_angles, "x^2 + 4*y^2 + 4*z^2 - 4"), 2, true);
  check_loops(section(sphere_by_angles, "(x + 2*y)^2*(z - 3)"), 2, true);
}

TEST_CASE("collapsed points: a line of contact through the apex of a cone is one line") {
  const SurfaceResult line = section(cone, "x - z");
  CHECK(line.status == Status::certified);
  CHECK(line.components.size() == 1);
  CHECK(line.components.front().tangential);
  CHECK(line.singular_points.empty());
}

TEST_CASE("collapsed points: curves go on through the poles of surfaces of degree up to 8") {
  check_loops(section(revolution("v", "v^2 + v^4"), "x + z"), 1, false);
  check_loops(section(revolution("v", "v^2 + v^6"), "x + z"), 1, false);
  check_loops(section(revolution("v", "v^4 + v^8"), "x - z"), 1, false);
}

TEST_CASE("collapsed points: a cusp in a pole is none of the crossings that two pairs of parameters suggest") {
  check_singular(section(sphere_by_angles, "y*(1 - z) - x^2"), SurfaceSingularity::cusp, 4);
  check_singular(section(revolution("v", "v^2"), "y*z - x^2"), SurfaceSingularity::cusp, 4);
}

TEST_CASE("collapsed points: crossings in a pole are counted in space") {
  // Two curves that cross, each found twice.
  check_singular(section(revolution("v", "v^2"), "(y - z)*(y + z)"), SurfaceSingularity::crossing, 8);
  // Two sheets through the origin.
  check_singular(section(revolution("2*v", "v^3"), "x + z"), SurfaceSingularity::crossing, 4);
}

TEST_CASE("collapsed points: curves go on through a pole that is a base point at infinity") {
  check_loops(section(sphere_from_pole, "x + y + z - 1"), 1, false);
  check_loops(section(sphere_from_pole, "(x + y + z - 1)^2"), 1, true);
  // A diagonal, where both charts around the base point meet.
  check_loops(section(sphere_from_pole, "x - y"), 1, false);
  check_singular(section(sphere_from_pole, "y*(1 - z) - x^2"), SurfaceSingularity::cusp, 2);
  // Two circles with one tangent.
  check_singular(section(sphere_from_pole, "(x + y + z - 1)*(2*x + 2*y + z - 1)"), SurfaceSingularity::crossing, 4);
}

TEST_CASE("collapsed points: where a curve ends at a base point no contact is claimed") {
  // The weight vanishes along two real directions into the base point.
  const SurfaceResult hyperbola = section({"2*u", "2*v", "u^2 - v^2 - 1", "u^2 - v^2 + 1"}, "x + 2*y + z - 1");
  CHECK(hyperbola.status == Status::numeric);
  CHECK(hyperbola.singular_points.empty());
  CHECK(std::none_of(hyperbola.components.begin(), hyperbola.components.end(),
                     [](const auto& c) { return c.kind == SurfaceComponentKind::point; }));
}
