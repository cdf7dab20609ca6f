// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>

// Two patches that have a border in common and nothing else.
using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

SurfaceResult solved(const PatchText& first, const PatchText& second) {
  Options options;
  options.tolerance = 1e-6;
  return intersect_patches(patch(first), patch(second), options, Context());
}

/// One curve along x = 0 from y = 0 to y = 1, of height z(y).
template <class Height>
void check_border(const SurfaceResult& result, bool tangential, const Height& z) {
  CHECK(result.status == Status::certified);
  CHECK(result.singular_points.empty());
  REQUIRE(result.components.size() == 1);
  const SurfaceComponent& curve = result.components[0];
  CHECK(curve.kind == SurfaceComponentKind::curve);
  CHECK(curve.certified);
  CHECK(curve.tangential == tangential);
  CHECK(farthest(curve, [&](const SpacePoint& p) { return std::hypot(p[0], p[2] - z(p[1])); }) <= 2 * curve.error);
  const double from = curve.points.front().point[1];
  const double to = curve.points.back().point[1];
  CHECK(std::min(from, to) == doctest::Approx(0).epsilon(1e-12));
  CHECK(std::max(from, to) == doctest::Approx(1).epsilon(1e-12));
}

}  // namespace

TEST_CASE("Common borders: a straight one with parameters that are polynomials of each other") {
  const auto flat = [](double) { return 0.0; };
  for (const std::string y : {"v*(1 + v)/2", "1 - v*(1 + v)^2/4"}) {
    CAPTURE(y);
    // At an angle, on both sides, and in one plane along it.
    for (const PatchText& second :
         {PatchText{"u", y, "-u"}, PatchText{"-u", y, "u*v"}, PatchText{"-u", y, "u^2*(1 + v)"}}) {
      const bool tangential = second.z == "u^2*(1 + v)";
      check_border(solved({"u", "v", "u^2"}, second), tangential, flat);
      check_border(solved(second, {"u", "v", "u^2"}), tangential, flat);
    }
  }
}

TEST_CASE("Common borders: tangent planes that are equal in a point of it, patches on different sides of it") {
  const auto parabola = [](double y) { return y * y; };
  // In a rational point, in an irrational one, and in two.
  for (const std::string slope : {"(v - 1/2)", "(v^2 - 1/2)", "(v^3 + v - 1)", "(v^2 - v + 1/7)"}) {
    CAPTURE(slope);
    check_border(solved({"u", "v", "v^2 + u^2"}, {"-u", "v", "v^2 + u*" + slope}), false, parabola);
    check_border(solved({"u", "v", "v^2"}, {"-u*(2 - v)^2", "v*(2 - v)", "v^2 + u*(2 - v)^2*" + slope, "(2 - v)^2"}),
                 false, parabola);
  }
}
