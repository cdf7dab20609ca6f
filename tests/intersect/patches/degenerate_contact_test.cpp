// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>

// Contacts at which the second derivatives of the distance have rank one: cusps, branches that touch, and points on
// their own, at (1/2, 1/3) unless said otherwise.
using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

const std::string ground = "(u*v/3 + u^2/5)";
const std::string x = "(u - 1/2)";
const std::string y = "(v - 1/3)";

SurfaceResult solved(const PatchText& first, const PatchText& second) {
  return intersect_patches(patch(first), patch(second), Options(), Context());
}

/// y^2 a + c x^m: what it says.
struct Planted {
  std::string name;
  std::string height;
  unsigned long curves;
  unsigned long points;
  SurfaceSingularity kind;
};

const std::vector<Planted> planted{
    {"A2", y + "^2 - 2*" + x + "^3", 2, 0, SurfaceSingularity::cusp},
    {"A2, along v", x + "^2 + " + y + "^3", 2, 0, SurfaceSingularity::cusp},
    {"A2, oblique", "(" + x + " + 2*" + y + ")^2 - " + x + "^3 + " + x + "*" + y + "^2/2", 2, 0,
     SurfaceSingularity::cusp},
    {"A3, on its own", "2*" + y + "^2 + " + x + "^4", 0, 1, SurfaceSingularity::contact},
    {"A3, two branches", y + "^2 - " + x + "^4", 4, 0, SurfaceSingularity::cusp},
    {"A3, two branches that bend to one side", "(" + y + " - " + x + "^2)*(" + y + " - 2*" + x + "^2)", 4, 0,
     SurfaceSingularity::cusp},
    {"A4", x + "^2 - " + y + "^5", 2, 0, SurfaceSingularity::cusp},
    {"A5, on its own", y + "^2 + " + x + "^6", 0, 1, SurfaceSingularity::contact},
    {"A5, two branches", y + "^2 - 3*" + x + "^6", 4, 0, SurfaceSingularity::cusp},
};

/// Affine coordinates by u, v and z, rotated in both planes by rational rotations, scaled and moved.
PatchText placed(const std::string& z, const std::string& scale, const std::string& by) {
  const auto moved = [&](const std::string& coordinate) { return scale + "*(" + coordinate + ") + " + by; };
  const std::string turned = "(3/5*v - 4/5*" + z + ")";
  const std::string up = "(4/5*v + 3/5*" + z + ")";
  return {moved("5/13*u - 12/13*" + turned), moved("12/13*u + 5/13*" + turned), moved(up)};
}

void check(const SurfaceResult& result, const Planted& expected, double size) {
  CHECK(result.status == Status::certified);
  CHECK(result.counts.curves == expected.curves);
  CHECK(result.counts.loops == 0);
  CHECK(result.counts.points == expected.points);
  REQUIRE(result.singular_points.size() == 1);
  const SurfaceSingularPoint& singular = result.singular_points[0];
  CHECK(singular.kind == expected.kind);
  CHECK(singular.half_branches == expected.curves);
  CHECK(singular.certified);
  for (const SurfaceComponent& component : result.components) {
    CHECK(component.certified);
    CHECK(component.error <= 1.001e-9 * 2 * size);
    if (component.kind != SurfaceComponentKind::curve) continue;
    // From border to the contact, which its polyline reaches.
    const bool starts = component.start.kind == BranchEndKind::singular;
    CHECK((starts ? component.end.kind : component.start.kind) == BranchEndKind::border);
    const SurfacePoint& last = starts ? component.points.front() : component.points.back();
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::fabs(last.parameters[k] - singular.at.parameters[k]) < 1e-15);
  }
}

}  // namespace

TEST_CASE("Degenerate contacts: cusps, touching branches and points are certified") {
  for (const Planted& given : planted) {
    CAPTURE(given.name);
    const PatchText first{"u", "v", ground};
    const PatchText second{"u", "v", ground + " - (" + given.height + ")"};
    check(solved(first, second), given, 1);
    check(solved(second, first), given, 1);
  }
}

TEST_CASE("Degenerate contacts: turned, moved and scaled") {
  for (const Planted& given : planted)
    for (const std::string scale : {"1", "1e-6", "1e6"}) {
      CAPTURE(given.name);
      CAPTURE(scale);
      const std::string by = scale == "1" ? "7/3" : "0";
      const SurfaceResult result =
          solved(placed(ground, scale, by), placed("(" + ground + " - (" + given.height + "))", scale, by));
      check(result, given, std::stod(scale));
    }
}

TEST_CASE("Degenerate contacts: with weights, and in other parameters on the second patch") {
  // Both maps are multiplied by weights; u and v are exchanged on the second, and reach further.
  for (const Planted& given : planted) {
    CAPTURE(given.name);
    const std::string w = "(1 + u/2 + v/4)";
    const std::string height = ground + " - (" + given.height + ")";
    std::string exchanged;
    for (const char c : height)
      exchanged += c == 'u' ? "(5/4*v - 1/8)" : c == 'v' ? "(3/2*u - 1/8)" : std::string(1, c);
    const SurfaceResult result =
        solved({"u*" + w, "v*" + w, ground + "*" + w, w}, {"5/4*v - 1/8", "3/2*u - 1/8", exchanged});
    check(result, given, 1);
  }
}

TEST_CASE("Degenerate contacts: the branches are where they are planted") {
  // y = x^(m / 2), and the polylines are that near.
  for (const long m : {3, 4, 5, 6}) {
    CAPTURE(m);
    const SurfaceResult result = solved({"u", "v", "0"}, {"u", "v", y + "^2 - " + x + "^" + std::to_string(m)});
    CHECK(result.status == Status::certified);
    for (const SurfaceComponent& component : result.components)
      CHECK(farthest(component, [&](const SpacePoint& at) {
              const double far = std::fabs(at[0] - 0.5);
              return std::fabs(std::fabs(at[1] - 1.0 / 3) - std::pow(far, 0.5 * static_cast<double>(m)));
            }) <= 2 * component.error + 1e-15);
  }
}

TEST_CASE("Degenerate contacts: beside a near miss nothing is claimed of a contact") {
  for (const std::string miss : {"1/1000000000000", "-1/1000000000000"}) {
    CAPTURE(miss);
    const SurfaceResult result =
        solved({"u", "v", ground}, {"u", "v", ground + " + " + y + "^2 - " + x + "^3 + " + miss});
    for (const SurfaceSingularPoint& point : result.singular_points) CHECK_FALSE(point.certified);
  }
}

TEST_CASE("Degenerate contacts: of rank zero, and at irrational parameters, are left open") {
  for (const std::string& height : {x + "^3 - 3*" + x + "*" + y + "^2", std::string("(v^2 - 1/2)^2 - (u^2 - 1/3)^3")}) {
    CAPTURE(height);
    const SurfaceResult result = solved({"u", "v", ground}, {"u", "v", ground + " + " + height});
    CHECK(result.status == Status::numeric);
    for (const SurfaceSingularPoint& point : result.singular_points) CHECK_FALSE(point.certified);
    CHECK_FALSE(result.singular_points.empty());
  }
}
