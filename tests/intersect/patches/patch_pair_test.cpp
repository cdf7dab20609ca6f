// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <support/surface_checks.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

SurfaceResult solved(const symbolic::SurfacePiece& first, const symbolic::SurfacePiece& second,
                     double tolerance = 1e-5) {
  const Context context;
  Options options;
  options.tolerance = tolerance;
  return intersect_patches(first, second, options, context);
}

const PatchText ground{"u", "v", "0"};

struct Planted {
  std::string height;
  std::string expected;
};

// Over the unit square, against z = 0.
const std::vector<Planted> planted{
    {"u + 2*v - 1", "1 0 0 0 0 certified"},
    {"(u - 1/2)*(v - 1/2) - 1/64", "2 0 0 0 0 certified"},
    {"(u - 1/2)^2 + (v - 1/2)^2 - 1/9", "0 1 0 0 0 certified"},
    {"(u - 1/2)^2 + (v - 1/2)^2 - 5/16", "4 0 0 0 0 certified"},
    {"((u - 1/2)^2 + (v - 1/2)^2 - 1/25)*(u - 1/8)", "1 1 0 0 0 certified"},
    {"(u - 1/2)^2 + (v - 1/2)^2 + 1/1000000", "0 0 0 0 0 certified"},
    {"(u - 1/2)^2 + (v - 1/3)^2", "0 0 1 0 1 certified"},
    {"(u - 1/2)*(v - 1/2)", "4 0 0 0 1 certified"},
    {"u - v", "1 0 0 0 0 certified"},
    {"u + v", "0 0 1 0 0 certified"},
    {"u", "1 0 0 0 0 certified"},
};

PatchText exchanged(PatchText text) {
  for (std::string* part : {&text.x, &text.y, &text.z, &text.w})
    for (char& c : *part) c = c == 'u' ? 'v' : c == 'v' ? 'u' : c;
  return text;
}

}  // namespace

TEST_CASE("Patch pairs: planted curves, contacts and corners, in either order, with parameters exchanged and moved") {
  for (const Planted& curves : planted) {
    const std::string& height = curves.height;
    const std::string& expected = curves.expected;
    CAPTURE(height);
    const PatchText graph{"u", "v", height};
    CHECK(summary(solved(patch(ground), patch(graph))) == expected);
    CHECK(summary(solved(patch(graph), patch(ground))) == expected);
    CHECK(summary(solved(patch(exchanged(graph)), patch(ground))) == expected);
    CHECK(summary(solved(patch(ground), patch(exchanged(graph)))) == expected);
    const auto moved = [](const PatchText& p) {
      const std::string z = "(" + p.z + ")";
      return PatchText{"1000*(" + p.x + ") + 700*(" + p.y + ") + 50000", "900*(" + p.y + ") - 300*" + z,
                       "800*" + z + " + 250*(" + p.x + ") - 7000"};
    };
    CHECK(summary(solved(patch(moved(ground)), patch(moved(graph)))) == expected);
  }
}

TEST_CASE("Patch pairs: parameters are those of the domains, points are on both patches") {
  // The same square as u = 2 to 5 and v = -1 to 1.
  const symbolic::SurfacePiece graph =
      patch({"(u - 2)/3", "(v + 1)/2", "((u - 2)/3 - 1/2)^2 + ((v + 1)/2 - 1/2)^2 - 1/9"},
            {symbolic::Interval{2, 5}, symbolic::Interval{-1, 1}});
  const SurfaceResult result = solved(graph, patch(ground));
  REQUIRE(result.components.size() == 1);
  const SurfaceComponent& loop = result.components[0];
  CHECK(loop.points.front().parameters == loop.points.back().parameters);
  for (const SurfacePoint& at : loop.points) {
    CHECK(std::fabs((at.parameters[0] - 2) / 3 - at.point[0]) < 1e-13);
    CHECK(std::fabs((at.parameters[1] + 1) / 2 - at.point[1]) < 1e-13);
    CHECK(std::fabs(at.parameters[2] - at.point[0]) < 1e-13);
    CHECK(std::fabs(at.parameters[3] - at.point[1]) < 1e-13);
  }
}

TEST_CASE("Patch pairs: polylines keep to the tolerance, relative to the smaller patch") {
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const SurfaceResult result =
        solved(patch({"9*u - 4", "9*v - 4", "0"}), patch({"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"}), tolerance);
    REQUIRE(result.components.size() == 1);
    const SurfaceComponent& loop = result.components[0];
    CHECK(loop.error <= tolerance + 1e-14);
    CHECK(farthest(loop, [](const SpacePoint& p) {
            return std::hypot(std::hypot(p[0] - 0.5, p[1] - 0.5) - 1.0 / 3, p[2]);
          }) <= loop.error);
    CHECK(length_of(loop) == doctest::Approx(2 * std::numbers::pi / 3).epsilon(30 * tolerance));
  }
}

TEST_CASE("Patch pairs: where a border crosses the other patch to the side of its normal, the curve goes out") {
  // The plane x = 1/2 with the normal (1, 0, 0), and turned round.
  for (const bool turned : {false, true}) {
    const PatchText wall{"1/2", turned ? "3*v - 1" : "3*u - 1", turned ? "u - 1/2" : "v - 1/2"};
    const SurfaceResult result = solved(patch(ground), patch(wall));
    REQUIRE(result.components.size() == 1);
    for (const BranchEnd& end : {result.components[0].start, result.components[0].end}) {
      CHECK(end.kind == BranchEndKind::border);
      CHECK(std::abs(end.side[1]) == 1);
      CHECK(end.transition == (turned ? Transition::in : Transition::out));
    }
  }
}

TEST_CASE("Patch pairs: arcs end in the contact where they cross, and a touching point is tangential") {
  const SurfaceResult crossing = solved(patch(ground), patch({"u", "v", "(u - 1/2)*(v - 1/3)"}));
  REQUIRE(crossing.singular_points.size() == 1);
  CHECK(crossing.singular_points[0].kind == SurfaceSingularity::crossing);
  CHECK(crossing.singular_points[0].half_branches == 4);
  CHECK(crossing.singular_points[0].at.point[1] == doctest::Approx(1.0 / 3));
  for (const SurfaceComponent& arc : crossing.components)
    CHECK((arc.start.singular_point == 0) != (arc.end.singular_point == 0));

  const SurfaceResult touching = solved(patch(ground), patch({"u", "v", "(u - 1/2)^2 + (v - 1/3)^2"}));
  REQUIRE(touching.components.size() == 1);
  CHECK(touching.components[0].tangential);
  CHECK(touching.components[0].points.size() == 1);
  CHECK(touching.singular_points.at(0).kind == SurfaceSingularity::contact);
}

TEST_CASE("Patch pairs: contact along a curve is a tangential component from border to border, or closed") {
  const SurfaceResult line = solved(patch(ground), patch({"u", "v", "(u - 1/2)^2"}));
  CHECK(line.status == Status::certified);
  REQUIRE(line.components.size() == 1);
  CHECK(line.components[0].kind == SurfaceComponentKind::curve);
  CHECK(line.components[0].tangential);
  // An ellipse without rational points.
  const SurfaceResult loop = solved(patch(ground), patch({"u", "v", "(u^2 + 2*v^2 - u - 2*v + 13/20)^2"}));
  CHECK(loop.status == Status::certified);
  REQUIRE(loop.components.size() == 1);
  CHECK(loop.components[0].kind == SurfaceComponentKind::loop);
  CHECK(loop.components[0].tangential);
}

TEST_CASE("Patch pairs: what cannot be decided is not certified") {
  // Contact of higher order along a line and in a point, and along a line at an irrational parameter; weights of both
  // signs. Neither surface has a low degree.
  const PatchText hill{"u", "v", "u^2*v^2"};
  for (const std::string height : {"(u - 1/2)^4", "(u - 1/2)^4 + (v - 1/2)^4", "(u^2 - 1/3)^2"}) {
    CAPTURE(height);
    const SurfaceResult result = solved(patch(hill), patch({"u", "v", "u^2*v^2 + " + height}));
    CHECK(result.status == Status::numeric);
    CHECK((!result.singular_points.empty() || !result.warnings.empty()));
  }
  const SurfaceResult mixed = solved(patch(ground), patch({"u", "v", "u - v", "1 - 2*u"}));
  CHECK(mixed.status == Status::numeric);
  CHECK_FALSE(mixed.warnings.empty());
  // All of one sign are the same as positive ones.
  CHECK(summary(solved(patch(ground), patch({"-u", "-v", "1/3 - u", "-1"}))) == "1 0 0 0 0 certified");
}

TEST_CASE("Patch pairs: contact of any order with a plane is a section, along a line at any parameter") {
  for (const auto& [height, at] : std::vector<std::pair<std::string, double>>{
           {"(u - 1/2)^4", 0.5}, {"(u^2 - 1/3)^2", std::sqrt(1.0 / 3)}, {"(u - 1/2)^3", 0.5}}) {
    CAPTURE(height);
    const SurfaceResult result = solved(patch(ground), patch({"u", "v", height}));
    REQUIRE(summary(result) == "1 0 0 0 0 certified");
    const SurfaceComponent& line = result.components[0];
    CHECK(line.tangential);
    CHECK(farthest(line, [&](const SpacePoint& p) { return std::hypot(p[0] - at, p[2]); }) <= line.error);
    CHECK(length_of(line) == doctest::Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("Patch pairs: no patches are refused, and a limit keeps what it found") {
  CHECK_THROWS_AS(solved(patch(ground), patch({"u", "u^2", "1"})), InvalidInput);
  CHECK_THROWS_AS(solved(patch(ground, {symbolic::Interval{0, 0}, symbolic::Interval{0, 1}}), patch(ground)),
                  InvalidInput);
  Context context;
  context.cancel();
  Options options;
  options.tolerance = 1e-13;
  const SurfaceResult result =
      intersect_patches(patch(ground), patch({"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"}), options, context);
  CHECK(result.status == Status::incomplete);
  CHECK(result.limit.has_value());
}
