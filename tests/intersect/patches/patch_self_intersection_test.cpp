// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

SurfaceResult with_itself(const symbolic::SurfacePiece& piece, double tolerance = 1e-5) {
  const Context context;
  Options options;
  options.tolerance = tolerance;
  return intersect_patch_with_itself(piece, options, context);
}

const Sides upright{symbolic::Interval{ratio(-3, 2), ratio(3, 2)}, symbolic::Interval{0, 1}};
const PatchText umbrella{"u*v", "u", "v^2"};
const PatchText nodal{"u^2 - 1", "u^3 - u", "v"};
const PatchText enneper{"u - u^3/3 + u*v^2", "v - v^3/3 + v*u^2", "u^2 - v^2"};

/// Both preimages of every point of a curve are apart, and have that point.
void check_preimages(const SurfaceComponent& component, const std::function<SpacePoint(double, double)>& map) {
  for (const SurfacePoint& at : component.points) {
    const auto& [u, v, s, t] = at.parameters;
    const SpacePoint first = map(u, v);
    const SpacePoint second = map(s, t);
    double gap = 0;
    for (std::size_t k = 0; k < 3; ++k)
      gap = std::max({gap, std::fabs(first[k] - at.point[k]), std::fabs(second[k] - at.point[k])});
    CHECK(gap < 1e-11);
  }
}

}  // namespace

TEST_CASE("Self-intersection of a patch: Whitney's umbrella, from the border to its pinch point") {
  const SurfaceResult result = with_itself(patch(umbrella, square(1)));
  CHECK(summary(result) == "1 0 0 0 1 certified");
  REQUIRE(result.components.size() == 1);
  const SurfaceComponent& handle = result.components[0];
  CHECK(handle.mirrored);
  CHECK(handle.certified);
  CHECK(handle.error < 1e-4);
  CHECK(handle.start.kind == BranchEndKind::border);
  CHECK(handle.end.kind == BranchEndKind::singular);
  CHECK(handle.end.singular_point == 0);
  CHECK(farthest(handle, [](const SpacePoint& p) { return std::hypot(p[0], p[1], std::min(0.0, p[2])); }) <=
        handle.error);
  CHECK(length_of(handle) == doctest::Approx(1));
  check_preimages(handle, [](double u, double v) { return SpacePoint{u * v, u, v * v}; });
  REQUIRE(result.singular_points.size() == 1);
  const SurfaceSingularPoint& pinch = result.singular_points[0];
  CHECK(pinch.kind == SurfaceSingularity::pinch_point);
  CHECK(pinch.half_branches == 1);
  for (const double parameter : pinch.at.parameters) CHECK(std::fabs(parameter) <= pinch.radius);
}

TEST_CASE("Self-intersection of a patch: a cylinder over a nodal cubic, from border to border") {
  const SurfaceResult result = with_itself(patch(nodal, upright));
  CHECK(summary(result) == "1 0 0 0 0 certified");
  REQUIRE(result.components.size() == 1);
  const SurfaceComponent& line = result.components[0];
  CHECK_FALSE(line.mirrored);
  CHECK(farthest(line, [](const SpacePoint& p) { return std::hypot(p[0], p[1]); }) <= line.error + 1e-15);
  CHECK(length_of(line) == doctest::Approx(1));
  for (const SurfacePoint& point : line.points) {
    CHECK(std::fabs(std::fabs(point.parameters[0]) - 1) < 1e-12);
    CHECK(point.parameters[0] * point.parameters[2] < 0);
  }
}

TEST_CASE("Self-intersection of a patch: Enneper's surface on [-2, 2]^2 has two double curves, border to border") {
  const SurfaceResult result = with_itself(patch(enneper, square(2)));
  CHECK(summary(result) == "2 0 0 0 0 certified");
  REQUIRE(result.components.size() == 2);
  for (const SurfaceComponent& curve : result.components) {
    CHECK_FALSE(curve.mirrored);
    CHECK(curve.start.kind == BranchEndKind::border);
    CHECK(curve.end.kind == BranchEndKind::border);
    // u and -u with one v where 1 - u^2 / 3 + v^2 = 0, in the plane x = 0; or the other way round in y = 0.
    const bool in_x = std::fabs(curve.points[0].point[0]) < 1e-9;
    const std::size_t turned = in_x ? 0 : 1;
    for (const SurfacePoint& point : curve.points) {
      const auto& p = point.parameters;
      CHECK(std::fabs(p[turned] + p[2 + turned]) < 1e-10);
      CHECK(std::fabs(p[1 - turned] - p[3 - turned]) < 1e-10);
      CHECK(std::fabs(1 - p[turned] * p[turned] / 3 + p[1 - turned] * p[1 - turned]) < 1e-10);
    }
    // At |u| = 2 is v = 1 / sqrt(3), in space (0, 8 / sqrt(3) 11 / 18, 11 / 3).
    for (const SurfacePoint& end : {curve.points.front(), curve.points.back()}) {
      CHECK(std::fabs(end.parameters[turned]) == doctest::Approx(2));
      CHECK(std::fabs(end.parameters[1 - turned]) == doctest::Approx(1 / std::sqrt(3.0)));
      CHECK(std::fabs(end.point[2]) == doctest::Approx(11.0 / 3));
    }
  }
}

TEST_CASE("Self-intersection of a patch: embedded ones have none, proven") {
  CHECK(summary(with_itself(patch({"u", "v", "u^3 - 3*u*v^2"}, square(1)))) == "0 0 0 0 0 certified");
  CHECK(summary(with_itself(patch(nodal, {symbolic::Interval{ratio(-9, 10), ratio(3, 2)},
                                          symbolic::Interval{0, 1}}))) == "0 0 0 0 0 certified");
  CHECK(summary(with_itself(patch(umbrella, {symbolic::Interval{ratio(1, 16), 1}, symbolic::Interval{-1, 1}}))) ==
        "0 0 0 0 0 certified");
  CHECK(summary(with_itself(patch({"1 - u^2", "2*u", "v*(1 + u^2)", "1 + u^2"}))) == "0 0 0 0 0 certified");
  // Enneper's surface is embedded for u^2 + v^2 < 3.
  CHECK(summary(with_itself(patch(enneper, square(1)))) == "0 0 0 0 0 certified");
}

TEST_CASE("Self-intersection of a patch: nothing is certified of cuspidal edges") {
  CHECK(with_itself(patch({"u^2", "u^3", "v"}, square(1)), 1e-3).status != Status::certified);
  // (u, v) and (-u, v) have one point where v = -4 u^2, which ends in a pinch point.
  CHECK(summary(with_itself(patch({"u^2", "v", "u*v/4 + u^3"}, square(1)), 1e-3)) == "1 0 0 0 1 certified");
}

TEST_CASE("Self-intersection of a patch: unchanged by maps of space, and by exchanging parameters") {
  // Three times a rotation, moved; and with a weight that is positive on all.
  const auto mapped = [](const PatchText& p, bool projective) {
    const auto sum = [&p](const char* a, const char* b, const char* c, const char* d) {
      return std::string(a) + "*(" + p.x + ") + " + b + "*(" + p.y + ") + " + c + "*(" + p.z + ") + " + d;
    };
    return PatchText{sum("1", "2", "2", "7"), sum("2", "1", "-2", "0"), sum("2", "-2", "1", "-5"),
                     projective ? sum("0", "1/40", "1/50", "2") : "1"};
  };
  const auto exchanged = [](std::string text) {
    for (char& c : text) c = c == 'u' ? 'v' : c == 'v' ? 'u' : c;
    return text;
  };
  struct Case {
    PatchText text;
    Sides sides;
    std::string expected;
  };
  for (const Case& known : {Case{umbrella, square(1), "1 0 0 0 1 certified"},
                            {nodal, upright, "1 0 0 0 0 certified"},
                            {enneper, square(2), "2 0 0 0 0 certified"}}) {
    const PatchText& text = known.text;
    const Sides& sides = known.sides;
    const std::string& expected = known.expected;
    CAPTURE(text.x);
    CHECK(summary(with_itself(patch(mapped(text, false), sides), 1e-4)) == expected);
    CHECK(summary(with_itself(patch(mapped(text, true), sides), 1e-4)) == expected);
    const PatchText turned{exchanged(text.x), exchanged(text.y), exchanged(text.z)};
    CHECK(summary(with_itself(patch(turned, {sides[1], sides[0]}), 1e-4)) == expected);
  }
}
