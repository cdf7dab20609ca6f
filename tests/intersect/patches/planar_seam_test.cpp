// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/planar_seam.hpp>

// Patches that meet along a border in a plane between them.
using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

std::optional<bridge::ContainedBorder> seam(const PatchText& first, const PatchText& second) {
  const NetPair nets(first, second);
  const std::array<symbolic::Rational, 3> origin{};
  return planar_seam({nets.first, nets.second, nets.exact_first, nets.exact_second, origin});
}

SurfaceResult solved(const PatchText& first, const PatchText& second) {
  Options options;
  options.tolerance = 1e-7;
  return intersect_patches(patch(first), patch(second), options, Context());
}

/// Eighths of the unit sphere, v = 1 is the pole (0, 0, 1): x, y >= 0, and y <= 0 <= x with other parameters.
const PatchText octant{"(1-u^2)*(1-v^2)", "2*u*(1-v^2)", "2*v*(1+u^2)", "(1+u^2)*(1+v^2)"};
const PatchText beside{"(1-u^2)*2*v*(2-v)", "-2*u*2*v*(2-v)", "((2-v)^2-v^2)*(1+u^2)", "(1+u^2)*((2-v)^2+v^2)"};
/// A quarter of a cylinder below the octant, and of the disc between both.
const PatchText cylinder{"1-u^2", "2*u", "(v-1)*(1+u^2)", "1+u^2"};
const PatchText disc{"(1-u^2)*v", "2*u*v", "0", "1+u^2"};

}  // namespace

TEST_CASE("Planar seams: octants along a meridian, a cylinder below one, with a disc, exchanged") {
  struct Pair {
    PatchText first;
    PatchText second;
    bool tangential;
  };
  const auto on_meridian = [](const SpacePoint& p) { return std::fabs(std::hypot(p[0], p[2]) - 1) + std::fabs(p[1]); };
  const auto on_equator = [](const SpacePoint& p) { return std::fabs(std::hypot(p[0], p[1]) - 1) + std::fabs(p[2]); };
  for (const Pair& pair : {Pair{octant, beside, true}, Pair{octant, cylinder, true}, Pair{cylinder, disc, false},
                           Pair{octant, disc, false}})
    for (const bool exchanged : {false, true}) {
      CAPTURE(pair.second.x);
      const SurfaceResult result = exchanged ? solved(pair.second, pair.first) : solved(pair.first, pair.second);
      REQUIRE(summary(result) == "1 0 0 0 0 certified");
      const SurfaceComponent& curve = result.components[0];
      CHECK(curve.certified);
      CHECK(curve.reason.empty());
      CHECK(curve.tangential == pair.tangential);
      CHECK(length_of(curve) == doctest::Approx(std::acos(0.0)).epsilon(1e-6));
      const bool meridian = pair.second.x == beside.x;
      CHECK((meridian ? farthest(curve, on_meridian) : farthest(curve, on_equator)) <= 2 * curve.error);
    }
}

TEST_CASE("Planar seams: the border that is one, and none where a patch is in the plane elsewhere or on both sides") {
  const PatchText arch{"u", "v", "v*(1-v)"};
  const auto found = seam(arch, {"-u", "v", "v*(1-v) + u*v"});
  REQUIRE(found);
  CHECK(found->axis == 0);
  CHECK(found->side == -1);
  // In its plane, beyond its ends; on its side, across it, beside a part of the border, another curve.
  CHECK(seam(arch, {"0", "v", "v*(1-v) - u"}));
  CHECK_FALSE(seam(arch, {"2*u", "v", "v*(1-v) + u"}));
  CHECK_FALSE(seam(arch, {"u*(2*u-1)", "v", "v*(1-v) - u"}));
  CHECK(seam(arch, {"-u", "2*v - 1/2", "(2*v - 1/2)*(3/2 - 2*v)"}));
  CHECK_FALSE(seam(arch, {"-u", "v/2 + 3/4", "(v/2 + 3/4)*(1/4 - v/2)"}));
  CHECK_FALSE(seam(arch, {"-u", "v", "v*(1-v)/2"}));
  // Both are in the plane x = 0 along a second border, too.
  CHECK_FALSE(seam({"u*(1-u)", "v", "v*(1-v) + u"}, {"u*(u-1)", "v", "v*(1-v) + u"}));
  CHECK_FALSE(seam({"u*v", "v", "v*(1-v) + u"}, {"-u*v", "v", "v*(1-v) + u"}));
}
