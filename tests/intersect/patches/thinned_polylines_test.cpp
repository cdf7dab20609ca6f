// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/thinned_polylines.hpp>

using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

/// The unit circle in the plane z = 0 by a regular polygon.
SurfaceComponent circle(std::size_t corners) {
  SurfaceComponent component;
  component.kind = SurfaceComponentKind::loop;
  component.certified = true;
  component.error = 1 - std::cos(std::numbers::pi / static_cast<double>(corners)) + 1e-14;
  for (std::size_t i = 0; i <= corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i % corners) / static_cast<double>(corners);
    component.points.push_back({{angle, 0, angle, 0}, {std::cos(angle), std::sin(angle), 0}});
  }
  return component;
}

double off_circle(const SpacePoint& p) { return std::fabs(std::hypot(p[0], p[1]) - 1) + std::fabs(p[2]); }

}  // namespace

TEST_CASE("Thinned polylines: the error remains a bound, ends and short polylines remain") {
  for (const std::size_t corners : {1000U, 1001U, 1023U}) {
    CAPTURE(corners);
    SurfaceResult result;
    result.components = {circle(corners), circle(8), circle(corners / 3)};
    thin_polylines(result, 200);
    CHECK(result.warnings.size() == 1);
    std::size_t count = 0;
    for (const SurfaceComponent& component : result.components) {
      count += component.points.size();
      CHECK(component.certified);
      CHECK(component.points.front().point == component.points.back().point);
      CHECK(component.points.front().parameters[0] == 0);
      CHECK(farthest(component, off_circle) <= component.error);
      // The error is not much larger than it must be: chords of equal angles.
      const double angle = std::numbers::pi / static_cast<double>(component.points.size() - 1);
      CHECK(component.error < 8 * (1 - std::cos(angle)));
    }
    CHECK(count <= 200);
    CHECK(result.components[1].points.size() == 9);
  }
}

TEST_CASE("Thinned polylines: nothing changes below the limit") {
  SurfaceResult result;
  result.components = {circle(99)};
  thin_polylines(result, 100);
  CHECK(result.components[0].points.size() == 100);
  CHECK(result.warnings.empty());
}
