// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>

// Patches that touch along curves: crossed by branches, and along borders.
using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

SurfaceResult solved(const PatchText& first, const PatchText& second, double tolerance = Options().tolerance) {
  Options options;
  options.tolerance = tolerance;
  return intersect_patches(patch(first), patch(second), options, Context());
}

struct Seam {
  std::string name;
  PatchText first;
  PatchText second;
};

const std::vector<Seam> seams{
    {"on both sides, tangent", {"u", "v", "u^2"}, {"1 + u", "v", "1 + 2*u - 3*u^2"}},
    {"on both sides, with equal curvature", {"u", "v", "u^2"}, {"1 + u", "v", "1 + 2*u + u^2 - u^3"}},
    {"on both sides, turned round", {"u", "v", "u^2"}, {"2 - u", "1 - v", "1 + 2*(1 - u) - 3*(1 - u)^2"}},
    {"on both sides, parameters exchanged", {"u", "v", "u^2"}, {"1 + v", "u", "1 + 2*v - 3*v^2"}},
    {"on both sides, a part of the border", {"u", "v", "u^2"}, {"1 + u", "v/2 + 1/4", "1 + 2*u - 3*u^2"}},
    {"on both sides, parts of both borders", {"u", "v", "u^2"}, {"1 + u", "v + 1/2", "1 + 2*u - 3*u^2"}},
    {"on both sides, bent along the seam", {"u", "v", "u*v"}, {"-u", "v", "-u*v + u^2*(1 + v)"}},
    {"on one side", {"u", "v", "u*v"}, {"u", "v", "u*v + u^2*(1 + v)/4"}},
    {"inside of the other patch", {"u", "v", "0"}, {"u", "v/4 + 1/2", "v^2*(1 + u)"}},
    {"partly inside of the other patch", {"u", "v", "0"}, {"u + 1/2", "v/2 + 1/4", "v^2*(1 + u)"}},
    {"a quarter of a cylinder on its plane", {"u - 1", "v", "0"}, {"2*u", "v*(1 + u^2)", "2*u^2", "1 + u^2"}},
};

}  // namespace

TEST_CASE("Patch contacts: a common border with common tangent planes is certified, whatever the sides") {
  for (const Seam& seam : seams)
    for (const bool exchanged : {false, true}) {
      CAPTURE(seam.name);
      CAPTURE(exchanged);
      const SurfaceResult result = exchanged ? solved(seam.second, seam.first) : solved(seam.first, seam.second);
      CHECK(result.status == Status::certified);
      CHECK(result.warnings.empty());
      REQUIRE(result.components.size() == 1);
      const SurfaceComponent& curve = result.components[0];
      CHECK(curve.kind == SurfaceComponentKind::curve);
      CHECK(curve.tangential);
      CHECK(curve.certified);
      CHECK(curve.reason.empty());
      CHECK(curve.error < 1e-9);
    }
}

TEST_CASE("Patch contacts: a ruling along which a plane touches a cylinder, in a position that doubles round") {
  // Turned by 1/3 (2 -1 2, 2 2 -1, -1 2 2); the plane touches at u = 1/2. Nothing but rounding is in the condition that
  // both normals be orthogonal to the ruling.
  const std::string x = "(1 - u^2)";
  const std::string y = "2*u";
  const std::string z = "v*(1 + u^2)";
  const PatchText cylinder{"2*" + x + " - " + y + " + 2*" + z, "2*" + x + " + 2*" + y + " - " + z,
                           "2*" + y + " + 2*" + z + " - " + x, "3 + 3*u^2"};
  const std::string a = "(3 - 4*(2*u - 1))";
  const std::string b = "(4 + 3*(2*u - 1))";
  const std::string c = "5*(3*v - 1)";
  const PatchText plane{"(2*" + a + " - " + b + " + 2*" + c + ")/15", "(2*" + a + " + 2*" + b + " - " + c + ")/15",
                        "(2*" + b + " + 2*" + c + " - " + a + ")/15"};
  for (const bool exchanged : {false, true}) {
    CAPTURE(exchanged);
    const SurfaceResult result = exchanged ? solved(plane, cylinder) : solved(cylinder, plane);
    CHECK(result.status == Status::certified);
    REQUIRE(result.components.size() == 1);
    CHECK(result.components[0].kind == SurfaceComponentKind::curve);
    CHECK(result.components[0].tangential);
    for (const SurfacePoint& point : result.components[0].points) {
      const std::size_t own = exchanged ? 2 : 0;
      CHECK(std::fabs(point.parameters[own] - 0.5) < 1e-12);
      CHECK(std::fabs(point.parameters[own + 1] - (3 * point.parameters[3 - own] - 1)) < 1e-9);
    }
  }
}

TEST_CASE("Patch contacts: beside a seam the patches may meet again") {
  const SurfaceResult result = solved({"u", "v", "u^2"}, {"1 - u", "v", "1 - 2*u + 5*u^2 - 8*u^3"});
  CHECK(result.status == Status::certified);
  REQUIRE(result.components.size() == 2);
  CHECK(std::count_if(result.components.begin(), result.components.end(),
                      [](const SurfaceComponent& c) { return c.tangential; }) == 1);
  for (const SurfaceComponent& component : result.components) {
    // At 4 u^2 = 8 u^3.
    const double x = component.tangential ? 1 : 0.5;
    for (const SurfacePoint& point : component.points) CHECK(point.point[0] == doctest::Approx(x));
  }
}

TEST_CASE("Patch contacts: a seam on one side with equal curvature, or met by a branch, is not certified") {
  for (const std::string difference : {"-u^3", "u^2*(v - 1/2 + u/3)"}) {
    const SurfaceResult result =
        solved({"u", "v", "u^2*(1 + v^2)"}, {"1 - u", "v", "(1 - u)^2*(1 + v^2) + " + difference});
    CHECK(result.status == Status::numeric);
    CHECK((!result.singular_points.empty() || !result.warnings.empty()));
  }
}

TEST_CASE("Patch contacts: curves of contact and branches that cross them keep to the tolerance, down to 1e-9") {
  const PatchText saddle{"u", "v", "u*v"};
  for (const std::string factor : {"(u + v - 1)", "(u + 2*v - 7/5)*2", "(u + v/3 - 2/3 + u*v/5)"}) {
    CAPTURE(factor);
    const PatchText second{"u", "v", "u*v + (u - v)^2*" + factor};
    for (const double tolerance : {1e-5, 1e-9}) {
      CAPTURE(tolerance);
      const SurfaceResult result = solved(saddle, second, tolerance);
      CHECK(result.status == Status::certified);
      // Both curves are cut where they cross.
      REQUIRE(result.components.size() == 4);
      CHECK(std::count_if(result.components.begin(), result.components.end(),
                          [](const SurfaceComponent& c) { return c.tangential; }) == 2);
      for (const SurfaceComponent& component : result.components) CHECK(component.error <= tolerance);
      REQUIRE(result.singular_points.size() == 1);
      CHECK(result.singular_points[0].radius < 1e-10);
    }
  }
}

TEST_CASE("Patch contacts: points of a branch beside its crossing are on both patches and on the branch") {
  const SurfaceResult result = solved({"u", "v", "u*v"}, {"u", "v", "u*v + (u - v)^2*(u + v - 1)"});
  REQUIRE(result.components.size() == 4);
  for (const SurfaceComponent& component : result.components)
    for (const SurfacePoint& at : component.points) {
      const double apart = component.tangential ? at.point[0] - at.point[1] : at.point[0] + at.point[1] - 1;
      CHECK(std::fabs(apart) <= 2 * component.error);
      CHECK(std::fabs(at.parameters[0] - at.parameters[2]) <= 2 * component.error);
    }
}

TEST_CASE("Patch contacts: points at irrational parameters are certified, on their own and where branches cross") {
  // At u = v = sqrt(1/2), at a root of degree 3 and at u = sqrt(1/2), v = sqrt(1/3); the saddle is met in other
  // parameters, too.
  const std::vector<std::array<std::string, 2>> roots{
      {"u - v", "u*v - 1/2"}, {"u^2 - v", "u*v - 1/3"}, {"u^2 - 1/2", "v^2 - 1/3"}};
  for (const auto& [a, b] : roots)
    for (const std::string form : {"x^2 + 2*y^2 + x*y", "x^2 - 2*y^2"}) {
      const bool definite = form[4] == '+';
      const std::string x = "(" + a + ")";
      const std::string y = "(" + b + ")";
      const std::string height = definite ? x + "^2 + 2*" + y + "^2 + " + x + "*" + y : x + "^2 - 2*" + y + "^2";
      CAPTURE(height);
      const SurfaceResult result = solved({"u", "v", "u*v/3"}, {"u", "v", "u*v/3 + " + height}, 1e-6);
      CHECK(result.status == Status::certified);
      REQUIRE(result.singular_points.size() == 1);
      CHECK(result.singular_points[0].certified);
      CHECK(result.singular_points[0].kind == (definite ? SurfaceSingularity::contact : SurfaceSingularity::crossing));
      CHECK(result.components.size() == (definite ? 1 : 4));
    }
}

TEST_CASE("Patch contacts: near misses at irrational parameters are none") {
  const std::string height = "(u - v)^2 + (u*v - 1/2)^2";
  for (const std::string gap : {"1/1000000000", "1/1000000000000"}) {
    const SurfaceResult apart = solved({"u", "v", "0"}, {"u", "v", height + " + " + gap}, 1e-6);
    for (const SurfaceSingularPoint& point : apart.singular_points) CHECK_FALSE(point.certified);
    CHECK(apart.components.empty());
  }
}
