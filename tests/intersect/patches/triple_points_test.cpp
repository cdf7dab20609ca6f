// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/triple_points.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

std::vector<SurfaceSingularPoint> triples_of(const SurfaceResult& result) {
  std::vector<SurfaceSingularPoint> triples;
  for (const SurfaceSingularPoint& point : result.singular_points)
    if (point.kind == SurfaceSingularity::triple_point) triples.push_back(point);
  return triples;
}

SurfaceResult with_itself(const PatchText& text, const Sides& sides, double tolerance = 1e-4) {
  Options options;
  options.tolerance = tolerance;
  return intersect_patch_with_itself(patch(text, sides), options, Context());
}

/// (b c, c a, a b) with a = u, b = v, c = 1 - u - v: the origin at (1, 0), (0, 1) and (0, 0), where the three
/// coordinate axes are double lines, each with a pinch point.
const PatchText steiner{"v*(1 - u - v)", "u*(1 - u - v)", "u*v"};

}  // namespace

TEST_CASE("Triple points: Steiner's surface has one, with three double lines through it") {
  const Sides sides{symbolic::Interval{ratio(-1, 4), ratio(5, 4)}, symbolic::Interval{ratio(-1, 3), ratio(6, 5)}};
  const SurfaceResult result = with_itself(steiner, sides);
  CHECK(summary(result) == "3 0 0 0 4 certified");
  const auto triples = triples_of(result);
  REQUIRE(triples.size() == 1);
  const SurfaceSingularPoint& triple = triples[0];
  CHECK(triple.certified);
  CHECK(triple.half_branches == 6);
  CHECK(triple.radius < 1e-15);
  for (const double x : triple.at.point) CHECK(std::fabs(x) <= triple.radius);
  REQUIRE(triple.third_preimage);
  std::vector<std::array<double, 2>> preimages{{triple.at.parameters[0], triple.at.parameters[1]},
                                               {triple.at.parameters[2], triple.at.parameters[3]},
                                               *triple.third_preimage};
  const std::vector<std::array<double, 2>> expected{{0, 0}, {0, 1}, {1, 0}};
  for (const auto& p : expected)
    CHECK(std::count_if(preimages.begin(), preimages.end(), [&](const auto& q) {
            return std::fabs(p[0] - q[0]) <= triple.radius && std::fabs(p[1] - q[1]) <= triple.radius;
          }) == 1);
}

TEST_CASE("Triple points: outside the domain there is none, and crossing preimages of two points are none") {
  // Without (0, 0) two of the three lines are left in part.
  const SurfaceResult part = with_itself(
      steiner, {symbolic::Interval{ratio(1, 16), ratio(5, 4)}, symbolic::Interval{ratio(1, 16), ratio(6, 5)}});
  CHECK(triples_of(part).empty());
  // Cylinder over a curve with three nodes: no triple point.
  const SurfaceResult nodes = with_itself({"u^3 - 3*u", "u^4 - 4*u^2", "v"}, square(2));
  CHECK(nodes.counts.curves == 3);
  CHECK(triples_of(nodes).empty());
}

TEST_CASE("Triple points: three sheets in general position, rational, at any scale") {
  // Steiner's surface after a projective map.
  const std::string w = "(5 + v*(1 - u - v) - u*v)";
  for (const std::string factor : {"1", "1/100000", "70000"}) {
    const SurfaceResult result =
        with_itself({factor + "*(v*(1 - u - v) + 2*u*v + 1)", factor + "*(u*(1 - u - v) - 3)", factor + "*u*v", w},
                    {symbolic::Interval{ratio(-1, 4), ratio(5, 4)}, symbolic::Interval{ratio(-1, 3), ratio(6, 5)}});
    CAPTURE(factor);
    const auto triples = triples_of(result);
    REQUIRE(triples.size() == 1);
    CHECK(triples[0].certified);
  }
}
