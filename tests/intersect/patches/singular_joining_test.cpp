// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include <eliminant/intersect/patches/singular_joining.hpp>

using namespace eliminant::intersect;

namespace {

const DomainBounds unit{std::array{0.0, 1.0}, std::array{0.0, 1.0}, std::array{0.0, 1.0}, std::array{0.0, 1.0}};

SurfaceSingularPoint singular(SurfaceSingularity kind, const std::array<double, 4>& at, double radius = 1e-15) {
  SurfaceSingularPoint point;
  point.kind = kind;
  point.at.parameters = at;
  point.radius = radius;
  point.certified = kind != SurfaceSingularity::undecided;
  return point;
}

/// Ends in these singular points.
SurfaceComponent between(std::size_t first, std::size_t second) {
  SurfaceComponent curve;
  curve.points.resize(2);
  curve.start.kind = curve.end.kind = BranchEndKind::singular;
  curve.start.singular_point = first;
  curve.end.singular_point = second;
  return curve;
}

}  // namespace

TEST_CASE("Singular points of pieces: contacts at one place are one, and curves end in that") {
  const std::array<double, 4> here{0.5, 0.25, 0.5, 0.5};
  const std::array<double, 4> there{0.5, 0.75, 0.5, 0.5};
  SurfaceResult result;
  result.singular_points = {singular(SurfaceSingularity::contact, here), singular(SurfaceSingularity::crossing, there),
                            singular(SurfaceSingularity::crossing, {0.5, 0.25 + 1e-12, 0.5, 0.5}),
                            // Of another kind at the same place, and a contact too far away to be the same.
                            singular(SurfaceSingularity::cusp, here),
                            singular(SurfaceSingularity::contact, {0.5, 0.25 + 1e-8, 0.5, 0.5})};
  result.components = {between(2, 1), between(1, 2), between(2, 0)};
  join_singular_points(result, unit);
  REQUIRE(result.singular_points.size() == 4);
  CHECK(result.singular_points[0].kind == SurfaceSingularity::crossing);
  CHECK(result.singular_points[0].half_branches == 4);
  CHECK(result.singular_points[1].half_branches == 2);
  CHECK(result.singular_points[2].kind == SurfaceSingularity::cusp);
  CHECK(result.singular_points[3].kind == SurfaceSingularity::contact);
  CHECK(result.singular_points[3].half_branches == 0);
  CHECK(result.components[0].start.singular_point == 0U);
  CHECK(result.components[0].end.singular_point == 1U);
  CHECK(result.components[2].start.singular_point == 0U);
  CHECK(result.components[2].end.singular_point == 0U);
}

TEST_CASE("Singular points of pieces: undecided boxes that touch are one, with a box around both") {
  SurfaceResult result;
  result.singular_points = {singular(SurfaceSingularity::undecided, {0.499, 0.5, 0.5, 0.5}, 1e-3),
                            singular(SurfaceSingularity::undecided, {0.503, 0.5, 0.5, 0.5}, 3e-3),
                            singular(SurfaceSingularity::undecided, {0.51, 0.5, 0.5, 0.5}, 3e-3),
                            singular(SurfaceSingularity::contact, {0.499, 0.5, 0.5, 0.5})};
  join_singular_points(result, unit);
  REQUIRE(result.singular_points.size() == 3);
  const SurfaceSingularPoint& both = result.singular_points[0];
  CHECK_FALSE(both.certified);
  CHECK(both.at.parameters[0] - both.radius <= 0.498);
  CHECK(both.at.parameters[0] + both.radius >= 0.506);
  CHECK(result.singular_points[1].at.parameters[0] == 0.51);
  CHECK(result.singular_points[2].kind == SurfaceSingularity::contact);
}
