// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/overlap_families.hpp>
#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

SurfaceResult solved(const SurfacePiece& first, const SurfacePiece& second, double tolerance = 1e-4) {
  const Context context;
  Options options;
  options.tolerance = tolerance;
  return intersect_patches(first, second, options, context);
}

std::array<unsigned long, 4> counts_of(const SurfaceResult& result) {
  return {result.counts.curves, result.counts.loops, result.counts.points, result.counts.overlaps};
}

/// Everything is proven, infinite if and only if there is an overlap.
void check_proven(const SurfaceResult& result) {
  CHECK((result.status == Status::infinite) == (result.counts.overlaps > 0));
  CHECK(result.rest_status.value_or(result.status) == Status::certified);
  CHECK(result.singular_points.empty());
  for (const SurfaceComponent& component : result.components) CHECK(component.certified);
}

std::array<double, 3> point_at(const SurfacePiece& patch, double u, double v) {
  std::array<double, 4> sum{};
  for (std::size_t k = 0; k < 4; ++k)
    for (const auto& term : patch.map.coordinates()[k].terms())
      sum[k] += fmpq_get_d(term.coefficient.get()) * std::pow(u, static_cast<double>(term.exponents[0])) *
                std::pow(v, static_cast<double>(term.exponents[1]));
  return {sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
}

/// Points have the parameters that they say, on both patches.
void check_points(const SurfaceResult& result, const SurfacePiece& first, const SurfacePiece& second) {
  for (const SurfaceComponent& component : result.components) {
    double worst = 0;
    double size = 1;
    for (const SurfacePoint& at : component.points) {
      const auto a = point_at(first, at.parameters[0], at.parameters[1]);
      const auto b = point_at(second, at.parameters[2], at.parameters[3]);
      for (std::size_t k = 0; k < 3; ++k) {
        size = std::max(size, std::fabs(at.point[k]));
        worst = std::max({worst, std::fabs(a[k] - at.point[k]), std::fabs(b[k] - at.point[k])});
      }
    }
    CHECK(worst < 1e-10 * size);
  }
}

/// How often the outline winds around a pair of parameters of the first patch.
int winding(const SurfaceComponent& outline, double u, double v) {
  double angle = 0;
  for (std::size_t i = 0; i + 1 < outline.points.size(); ++i) {
    const auto& p = outline.points[i].parameters;
    const auto& q = outline.points[i + 1].parameters;
    angle += std::atan2((p[0] - u) * (q[1] - v) - (p[1] - v) * (q[0] - u),
                        (p[0] - u) * (q[0] - u) + (p[1] - v) * (q[1] - v));
  }
  return static_cast<int>(std::lround(angle / (2 * 3.141592653589793)));
}

/// The outlines hold those parameters of the first patch whose points are on the second.
void check_places(const SurfaceResult& result, const OverlapPair& pair) {
  constexpr int parts = 24;
  const auto& sides = pair.first.region->sides;
  int wrong = 0;
  int inside = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < parts; ++j) {
      std::array<double, 2> at{};
      for (std::size_t k = 0; k < 2; ++k)
        at[k] = std::lerp(fmpq_get_d(sides[k].lower.get()), fmpq_get_d(sides[k].upper.get()),
                          ((k == 0 ? i : j) + 0.5) / parts);
      const OverlapPair::Place expected = pair.place(at[0], at[1]);
      if (expected == OverlapPair::Place::near_border) continue;
      int found = 0;
      for (const SurfaceComponent& component : result.components)
        if (component.kind == SurfaceComponentKind::overlap) found += winding(component, at[0], at[1]);
      if (found != (expected == OverlapPair::Place::inside ? 1 : 0)) ++wrong;
      inside += found;
    }
  CHECK(wrong == 0);
  // Narrow parts fall between the samples.
  if (result.counts.overlaps == 0) CHECK(inside == 0);
}

void check_pair(const OverlapPair& pair) {
  CAPTURE(pair.name);
  const SurfaceResult result = solved(pair.first, pair.second);
  CHECK(counts_of(result) == pair.counts);
  check_proven(result);
  check_points(result, pair.first, pair.second);
  check_places(result, pair);
  const std::array<Fraction, 2> same{};
  const SurfacePiece swapped = reparametrised(pair.first, same, true);
  for (const auto& [a, b] :
       {std::pair(pair.second, pair.first), std::pair(swapped, pair.second), std::pair(pair.second, swapped),
        std::pair(moved_in_space(pair.first), moved_in_space(pair.second))}) {
    const SurfaceResult other = solved(a, b);
    CHECK(counts_of(other) == pair.counts);
    check_proven(other);
    check_points(other, a, b);
  }
}

}  // namespace

TEST_CASE("Overlaps: two rectangles of one map, in any parameters, in either order, moved and scaled") {
  for (const unsigned seed : {1U, 2U})
    for (const OverlapPair& pair : overlaps_of_shared_maps(seed)) check_pair(pair);
}

TEST_CASE("Overlaps: planes, spheres, cylinders in different parameters") {
  for (const OverlapPair& pair : overlaps_of_common_surfaces()) check_pair(pair);
}

TEST_CASE("Overlaps: the outline of equal patches is their border, within the tolerance and its error") {
  const SurfacePiece bowl = patch({"u", "v", "u^2 + v^2"});
  for (const double tolerance : {1e-3, 1e-6}) {
    const SurfaceResult result = solved(bowl, bowl, tolerance);
    REQUIRE(result.components.size() == 1);
    const SurfaceComponent& outline = result.components[0];
    CHECK(outline.kind == SurfaceComponentKind::overlap);
    CHECK(outline.points.front().point == outline.points.back().point);
    CHECK(outline.error <= 2 * tolerance + 1e-13);
    // Sides are parabolas over the sides of the square.
    CHECK(farthest(outline, [](const SpacePoint& p) {
            const double x = std::min(std::fabs(p[0]), std::fabs(p[0] - 1));
            const double y = std::min(std::fabs(p[1]), std::fabs(p[1] - 1));
            return std::hypot(std::min(x, y), p[2] - p[0] * p[0] - p[1] * p[1]);
          }) <= outline.error);
    CHECK(winding(outline, 0.5, 0.5) == 1);
  }
}

TEST_CASE("Overlaps: common borders and corners say on which borders they are, and are tangential") {
  const PatchText text{"u", "v", "u^2 - u*v + v^3"};
  const Sides left{Interval{0, ratio(1, 2)}, Interval{0, 1}};
  const SurfaceResult border =
      solved(patch(text, left), patch(text, {Interval{ratio(1, 2), 1}, Interval{ratio(1, 4), 1}}));
  REQUIRE(border.components.size() == 1);
  const SurfaceComponent& curve = border.components[0];
  CHECK(curve.kind == SurfaceComponentKind::curve);
  CHECK(curve.tangential);
  CHECK(curve.start.side == std::array<int, 4>{1, 0, -1, -1});
  CHECK(curve.end.side == std::array<int, 4>{1, 1, -1, 1});
  const SurfaceResult corner = solved(patch(text, left), patch(text, {Interval{ratio(1, 2), 1}, Interval{1, 2}}));
  REQUIRE(corner.components.size() == 1);
  CHECK(corner.components[0].kind == SurfaceComponentKind::point);
  CHECK(corner.components[0].start.side == std::array<int, 4>{1, 1, -1, -1});
}

TEST_CASE("Overlaps: parts of a torus, of which a turn is given by other parameters") {
  const PatchText torus{"(8 + 2*v^2)*(1 - u^2)", "(8 + 2*v^2)*2*u", "6*v*(1 + u^2)", "(1 + u^2)*(1 + v^2)"};
  // u as (1 + u) / (1 - u): a quarter of a turn on.
  const PatchText turned{"-(8 + 2*v^2)*2*u", "(8 + 2*v^2)*(1 - u^2)", "6*v*(1 + u^2)", "(1 + u^2)*(1 + v^2)"};
  const SurfaceResult result =
      solved(patch(torus), patch(turned, {Interval{ratio(-1, 2), ratio(1, 2)}, Interval{0, 2}}));
  CHECK(counts_of(result) == std::array<unsigned long, 4>{0, 0, 0, 1});
  check_proven(result);
  // (1 + s) / (1 - s) from s = -1/2: u from 1/3 to 1.
  CHECK(winding(result.components.at(0), 0.34, 0.5) == 1);
  CHECK(winding(result.components.at(0), 0.32, 0.5) == 0);
}

TEST_CASE("Overlaps: a map that meets itself has the common part, and nothing is said of the rest") {
  // Both ends of u come to one line.
  const PatchText folded{"u*(1 - u)", "v", "u*(1 - u)*(1 - 2*u)"};
  const SurfaceResult result = solved(patch(folded, {Interval{ratio(-1, 4), ratio(5, 4)}, Interval{0, 1}}),
                                      patch(folded, {Interval{ratio(-1, 4), ratio(5, 4)}, Interval{0, 1}}));
  CHECK(result.status == Status::infinite);
  CHECK(result.rest_status == Status::numeric);
  CHECK(result.counts.overlaps == 1);
  CHECK_FALSE(result.warnings.empty());
}

TEST_CASE("Overlaps: nearly equal patches have none") {
  const SurfaceResult result =
      solved(patch({"u", "v", "u^2 - u*v + v^3"}), patch({"u", "v", "u^2 - u*v + v^3 + 1/1000000000000"}));
  CHECK(result.counts.overlaps == 0);
  CHECK(result.status != Status::infinite);
  // A border in common alone.
  const SurfaceResult border = solved(patch({"u", "v", "u*v"}), patch({"u", "v", "u*v*(1 + u)"}));
  CHECK(border.counts.overlaps == 0);
  CHECK(border.status != Status::infinite);
}

TEST_CASE("Overlaps: surfaces of several pieces have one for each pair of pieces, without their borders") {
  const symbolic::ParametricSurface cylinder = half_cylinder();
  Options options;
  options.tolerance = 1e-4;
  const SurfaceResult result = intersect_surface_surface({cylinder, cylinder}, options, Context());
  CHECK(counts_of(result) == std::array<unsigned long, 4>{0, 0, 0, 2});
  check_proven(result);
}

TEST_CASE("Overlaps: whole surfaces are one overlap only where their real points have an area in common") {
  const auto whole = [](const PatchText& text) {
    SurfacePiece piece = patch(text);
    piece.region.reset();
    return symbolic::ParametricSurface{{piece}};
  };
  Options options;
  options.tolerance = 1e-3;
  const auto intersection = [&](const PatchText& a, const PatchText& b) {
    return intersect_surface_surface({whole(a), whole(b)}, options, Context());
  };
  const PatchText sphere{"2*u", "2*v", "u^2 + v^2 - 1", "u^2 + v^2 + 1"};
  const SurfaceResult spheres = intersection(sphere, {"2*u", "u^2 + v^2 - 1", "2*v", "u^2 + v^2 + 1"});
  CHECK(counts_of(spheres) == std::array<unsigned long, 4>{0, 0, 0, 1});
  check_proven(spheres);
  const SurfaceResult saddles = intersection({"u", "v", "u*v"}, {"v", "u", "u*v"});
  CHECK(counts_of(saddles) == std::array<unsigned long, 4>{0, 0, 0, 1});
  check_proven(saddles);
  // Half planes of one plane: x >= 0, and x <= -1.
  const SurfaceResult halves = intersection({"u^2", "v", "0"}, {"-1 - u^2", "v", "0"});
  CHECK(halves.status == Status::numeric);
  CHECK(halves.counts.overlaps == 0);
}
