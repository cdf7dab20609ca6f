// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

using namespace eliminant;
using intersect::Status;
using intersect::SurfaceComponent;
using intersect::SurfaceComponentKind;
using intersect::SurfacePoint;
using intersect::SurfaceResult;
using symbolic::Rational;

namespace {

using Net = std::vector<std::vector<symbolic::ControlPoint>>;
using Heights = std::vector<std::vector<Rational>>;

Rational power(const Rational& base, std::size_t exponent) {
  Rational result(1);
  for (std::size_t i = 0; i < exponent; ++i) result = result * base;
  return result;
}

/// The graph of a polynomial over [x0, x1] x [y0, y1], by its Bernstein coefficients.
Net graph(const Heights& z,
          const std::array<Rational, 4>& over = {Rational(0), Rational(1), Rational(0), Rational(1)}) {
  Net net(z.size());
  const auto place = [](const Rational& a, const Rational& b, std::size_t i, std::size_t n) {
    return a + (b - a) * Rational(static_cast<long>(i)) / Rational(static_cast<long>(n));
  };
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t j = 0; j < z[i].size(); ++j)
      net[i].push_back({place(over[0], over[1], i, z.size() - 1), place(over[2], over[3], j, z[i].size() - 1), z[i][j],
                        Rational(1)});
  return net;
}

/// (x - 1/2)^2 + (y - 1/2)^2 - r^2 over the unit square.
Net bowl(const Rational& square_of_radius) {
  const Rational half(1, 2);
  const Rational r = square_of_radius;
  return graph({{half - r, Rational(0) - r, half - r},
                {Rational(0) - r, Rational(0) - half - r, Rational(0) - r},
                {half - r, Rational(0) - r, half - r}});
}

Net plane() { return graph({{Rational(0), Rational(0)}, {Rational(0), Rational(0)}}); }

/// Has only the origin in common with the unit square of the plane.
Net corner_from_outside() {
  const auto point = [](long x, long y, long z) {
    return symbolic::ControlPoint{Rational(x), Rational(y), Rational(z), Rational(1)};
  };
  return {{point(0, 0, 0), point(-1, 0, 1)}, {point(0, -1, 1), point(-1, -1, 3)}};
}

/// The same points by other parameters: weights c^i.
Net reweighted(Net net, const Rational& c) {
  for (std::size_t i = 0; i < net.size(); ++i)
    for (symbolic::ControlPoint& point : net[i])
      for (Rational& x : point) x = x * power(c, i);
  return net;
}

Net scaled(Net net, const Rational& factor) {
  for (auto& row : net)
    for (symbolic::ControlPoint& point : row)
      for (std::size_t k = 0; k < 3; ++k) point[k] = point[k] * factor;
  return net;
}

Net moved(Net net, const Rational& by) {
  for (auto& row : net)
    for (symbolic::ControlPoint& point : row)
      for (std::size_t k = 0; k < 3; ++k) point[k] = point[k] + by * point[3];
  return net;
}

SurfaceResult solve(const Net& first, const Net& second) {
  intersect::Options options;
  options.tolerance = 1e-4;
  return intersect::intersect_patches(symbolic::bezier_patch(first), symbolic::bezier_patch(second), options,
                                      Context());
}

void check_counts(const SurfaceResult& result, unsigned long curves, unsigned long loops, unsigned long points) {
  CHECK(result.status == Status::certified);
  CHECK(result.counts.curves == curves);
  CHECK(result.counts.loops == loops);
  CHECK(result.counts.points == points);
}

/// Ends on a border have its parameter exactly.
void check_ends(const SurfaceResult& result) {
  for (const SurfaceComponent& component : result.components) {
    if (component.kind != SurfaceComponentKind::curve) continue;
    for (const bool at_start : {true, false}) {
      const auto& side = (at_start ? component.start : component.end).side;
      const SurfacePoint& point = at_start ? component.points.front() : component.points.back();
      for (std::size_t k = 0; k < 4; ++k)
        if (side[k] != 0) CHECK(point.parameters[k] == (side[k] < 0 ? 0 : 1));
    }
  }
}

}  // namespace

TEST_CASE("weights that rise or fall by powers change parameters alone") {
  const Rational sixteenth(1, 16);
  for (const auto& [c, ratio] : {std::pair(Rational(1000), 1000.0), {Rational(1, 1000), 1e-3}, {Rational(3), 3.0}}) {
    const SurfaceResult result = solve(reweighted(bowl(sixteenth), c), plane());
    check_counts(result, 0, 1, 0);
    for (const SurfaceComponent& component : result.components)
      for (const SurfacePoint& point : component.points) {
        CHECK(std::fabs(std::hypot(point.point[0] - 0.5, point.point[1] - 0.5) - 0.25) < 1e-9);
        // The parameter of the patch that is given.
        const double u = point.parameters[0];
        CHECK(std::fabs(ratio * u / (1 - u + ratio * u) - point.point[0]) < 1e-9);
        CHECK(std::fabs(point.parameters[2] - point.point[0]) < 1e-9);
      }
  }
}

TEST_CASE("curves of tiny and of huge patches are followed") {
  for (const Rational& size : {Rational(1), power(Rational(1, 10), 30), power(Rational(10), 30)}) {
    const SurfaceResult result = solve(scaled(bowl(Rational(1, 16)), size), scaled(plane(), size));
    check_counts(result, 0, 1, 0);
  }
}

TEST_CASE("a small patch against a large one: directions at borders are decided") {
  const SurfaceResult result = solve(moved(scaled(plane(), Rational(10000000)), Rational(-300)),
                                     graph({{Rational(-301), Rational(-301)}, {Rational(-299), Rational(-299)}}));
  check_counts(result, 1, 0, 0);
}

TEST_CASE("errors hold what large coordinates round") {
  // No double is near 10^9 + 1/3.
  const Rational far = Rational(1000000000) + Rational(1, 3);
  const Net wall = {
      {{Rational(0), Rational(0), Rational(0), Rational(1)}, {Rational(0), Rational(1), Rational(0), Rational(1)}},
      {{Rational(0), Rational(0), Rational(1), Rational(1)}, {Rational(0), Rational(1), Rational(1), Rational(1)}}};
  constexpr double half_unit = 0x1p-24;
  SUBCASE("a shared edge") {
    const SurfaceResult result = solve(moved(plane(), far), moved(wall, far));
    check_counts(result, 1, 0, 0);
    CHECK(result.components.front().error > half_unit);
  }
  SUBCASE("a shared corner") {
    const SurfaceResult result = solve(moved(plane(), far), moved(corner_from_outside(), far));
    check_counts(result, 0, 0, 1);
    CHECK(result.components.front().error > half_unit);
  }
  SUBCASE("a contact") {
    const SurfaceResult result = solve(moved(bowl(Rational(0)), far), moved(plane(), far));
    check_counts(result, 0, 0, 1);
    CHECK(result.components.front().error > half_unit);
  }
}

TEST_CASE("the error of a shared corner is a distance in space") {
  const Rational size = power(Rational(10), 9);
  const SurfaceResult small = solve(plane(), corner_from_outside());
  const SurfaceResult large = solve(scaled(plane(), size), scaled(corner_from_outside(), size));
  check_counts(small, 0, 0, 1);
  check_counts(large, 0, 0, 1);
  CHECK(large.components.front().error >= 1e8 * small.components.front().error);
}

TEST_CASE("two branches that nearly cross, between corners") {
  // x - x^2 - y + y^2 + c: the diagonals of the square, apart for c > 0.
  for (const long digits : {6L, 10L}) {
    const Rational c = power(Rational(1, 10), static_cast<std::size_t>(digits));
    const Rational half(1, 2);
    const Net saddle = graph({{c, c - half, c}, {c + half, c, c + half}, {c, c - half, c}});
    for (const bool exchanged : {false, true}) {
      const SurfaceResult result = exchanged ? solve(plane(), saddle) : solve(saddle, plane());
      check_counts(result, 2, 0, 0);
      check_ends(result);
    }
  }
}

TEST_CASE("an arc that sets out away from its end") {
  const Net wave = graph({{Rational(15, 32), Rational(-19, 32)},
                          {Rational(-95, 384), Rational(69, 128)},
                          {Rational(-73, 192), Rational(-11, 192)},
                          {Rational(-79, 128), Rational(3, 64)},
                          {Rational(-27, 64), Rational(59, 96)},
                          {Rational(31, 96), Rational(247, 384)},
                          {Rational(-21, 64), Rational(17, 64)}});
  const Rational z(-1, 64);
  const Net part = graph({{z, z}, {z, z}}, {Rational(15, 16), Rational(9, 16), Rational(1, 8), Rational(11, 16)});
  const SurfaceResult result = solve(part, wave);
  check_counts(result, 1, 0, 0);
  check_ends(result);
}
