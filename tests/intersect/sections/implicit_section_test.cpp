// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <support/text_surfaces.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>

using namespace eliminant;
using intersect::BranchEndKind;
using intersect::Options;
using intersect::Status;
using intersect::SurfaceComponent;
using intersect::SurfaceComponentKind;
using intersect::SurfaceResult;
using intersect::SurfaceSingularity;
using intersect::SurfaceSurfaceProblem;
using symbolic::Interval;
using symbolic::ParametricSurface;
using symbolic::Polynomial;
using symbolic::Rational;
using test::in_space;
using test::map_of;

namespace {

using Point = std::array<double, 3>;

ParametricSurface whole(const std::vector<std::string>& texts) { return {{{map_of(texts), std::nullopt}}}; }

ParametricSurface patch(const std::vector<std::string>& texts, const Interval& u, const Interval& v) {
  return {{{map_of(texts), symbolic::ParameterRegion{{u, v}, false}}}};
}

/// Cut into four pieces in the middles.
ParametricSurface in_pieces(const std::vector<std::string>& texts, const Interval& u, const Interval& v,
                            const Rational& at_u, const Rational& at_v) {
  ParametricSurface surface;
  for (const Interval& a : {Interval{u.lower, at_u}, Interval{at_u, u.upper}})
    for (const Interval& b : {Interval{v.lower, at_v}, Interval{at_v, v.upper}})
      surface.pieces.push_back({map_of(texts), symbolic::ParameterRegion{{a, b}, false}});
  return surface;
}

const std::vector<std::string> sphere{"2*(1-u^2)*v", "4*u*v", "(v^2-1)*(1+u^2)", "(1+u^2)*(1+v^2)"};
const std::vector<std::string> torus{"(1-u^2)*(8+2*v^2)", "2*u*(8+2*v^2)", "6*v*(1+u^2)", "(1+u^2)*(1+v^2)"};
const std::vector<std::string> cone{"(1-u^2)*v", "2*u*v", "v*(1+u^2)", "1+u^2"};
const std::vector<std::string> cylinder{"2", "2*u", "v*(1+u^2)", "1+u^2"};
const std::vector<std::string> plane{"u", "v", "0", "1"};

SurfaceResult solve(const ParametricSurface& surface, const std::string& equation, double tolerance = 1e-6) {
  Options options;
  options.tolerance = tolerance;
  return intersect_surface_surface({surface, in_space(equation)}, options, Context());
}

/// Every point of every polyline, and the middle of every chord, is within the error of a curve, by its distance.
void check_distances(const SurfaceResult& result, const std::function<double(const Point&)>& distance) {
  for (const SurfaceComponent& component : result.components) {
    CHECK(component.error > 0);
    double largest = 0;
    for (std::size_t i = 0; i < component.points.size(); ++i) {
      const Point& p = component.points[i].point;
      largest = std::max(largest, distance(p));
      if (i == 0) continue;
      const Point& q = component.points[i - 1].point;
      largest = std::max(largest, distance({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])}));
    }
    CHECK(largest <= component.error);
  }
}

double length(double x, double y, double z = 0) { return std::sqrt(x * x + y * y + z * z); }

/// From a circle around a centre, in the plane through it with a unit normal.
double distance_to_circle(const Point& p, const Point& centre, const Point& normal, double radius) {
  Point d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = p[k] - centre[k];
  const double height = d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2];
  for (std::size_t k = 0; k < 3; ++k) d[k] -= height * normal[k];
  return length(length(d[0], d[1], d[2]) - radius, height);
}

double total_length(const SurfaceResult& result) {
  double sum = 0;
  for (const SurfaceComponent& component : result.components)
    for (std::size_t i = 1; i < component.points.size(); ++i) {
      const Point& p = component.points[i - 1].point;
      const Point& q = component.points[i].point;
      sum += length(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    }
  return sum;
}

constexpr double pi = 3.14159265358979323846;

}  // namespace

TEST_CASE("surface and equation: a plane cuts a sphere patch in a closed circle") {
  // A circle around the direction (1, 0, 0), inside the patch.
  for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
    const SurfaceResult result = solve(patch(sphere, {-1, 1}, {Rational(1) / Rational(5), 5}), "5*x - 4", tolerance);
    CHECK(result.status == Status::certified);
    REQUIRE(result.components.size() == 1);
    const SurfaceComponent& loop = result.components.front();
    CHECK(loop.kind == SurfaceComponentKind::loop);
    CHECK(loop.certified);
    CHECK(loop.points.front().point == loop.points.back().point);
    CHECK(loop.error < 3 * tolerance);
    CHECK(std::isnan(loop.points.front().parameters[2]));
    CHECK(std::isnan(loop.points.front().parameters[3]));
    check_distances(result, [](const Point& p) { return distance_to_circle(p, {0.8, 0, 0}, {1, 0, 0}, 0.6); });
    CHECK(std::fabs(total_length(result) - 2 * pi * 0.6) < 100 * tolerance);
  }
}

TEST_CASE("surface and equation: a sphere patch in pieces gives the same curves as in one") {
  const Interval u{-1, 1};
  const Interval v{Rational(1) / Rational(5), 5};
  for (const std::string equation :
       {"5*x - 4", "x + 2*y + 3*z - 1", "(x-1)^2 + y^2 + z^2 - 1/4", "y", "z", "y*z", "y*(y - z)", "x - 1"}) {
    const std::string named = equation;
    CAPTURE(named);
    const SurfaceResult one = solve(patch(sphere, u, v), equation);
    CHECK(one.status == Status::certified);
    for (const auto& [at_u, at_v] :
         {std::pair(Rational(0), Rational(1)), std::pair(Rational(1) / Rational(7), Rational(2)),
          std::pair(Rational(-1) / Rational(3), Rational(1))}) {
      const SurfaceResult cut = solve(in_pieces(sphere, u, v, at_u, at_v), equation);
      CHECK(cut.status == Status::certified);
      CHECK(cut.counts.curves == one.counts.curves);
      CHECK(cut.counts.loops == one.counts.loops);
      CHECK(cut.counts.points == one.counts.points);
      CHECK(cut.counts.singular == one.counts.singular);
      CHECK(std::fabs(total_length(cut) - total_length(one)) < 1e-4);
      for (std::size_t i = 0; i < std::min(one.singular_points.size(), cut.singular_points.size()); ++i)
        CHECK(cut.singular_points[i].kind == one.singular_points[i].kind);
    }
  }
}

TEST_CASE("surface and equation: weights may be negative everywhere, or on some charts") {
  // The plane z = 0, with u, or v, or both changed by a projectivity.
  for (const std::vector<std::string>& texts : {std::vector<std::string>{"u", "v*(u - 2)", "0", "u - 2"},
                                                {"-u", "-v", "0", "-1"},
                                                {"u*(3*v - 1)", "v*(u - 2)", "0", "(u - 2)*(3*v - 1)"}}) {
    CAPTURE(texts[3]);
    const SurfaceResult line = solve(whole(texts), "x");
    CHECK(line.status == Status::certified);
    CHECK(line.components.size() == 1);
    CHECK(line.counts.curves == 1);
    const SurfaceResult segment = solve(patch(texts, {-1, 1}, {2, 5}), "x");
    CHECK(segment.status == Status::certified);
    CHECK(segment.components.size() == 1);
    CHECK(segment.counts.curves == 1);
  }
}

TEST_CASE("surface and equation: a loop that doubles cannot tell from a point is not certified as one") {
  for (const char* const bend : {"1/10^28", "1/10^40"}) {
    CAPTURE(bend);
    const SurfaceResult result =
        solve(patch({"u", "v", "(2*u - 1)^2 + (3*v - 1)^2 - " + std::string(bend), "1"}, {0, 1}, {0, 1}), "z");
    CHECK(result.components.size() == 1);
    for (const SurfaceComponent& component : result.components) {
      CHECK((component.kind == SurfaceComponentKind::loop || !component.certified));
      CHECK(component.certified == component.reason.empty());
    }
  }
}

TEST_CASE("surface and equation: Villarceau's circles cross in two points") {
  const SurfaceResult result = solve(whole(torus), "3*x - 4*z", 1e-7);
  CHECK(result.status == Status::certified);
  CHECK(result.counts.curves == 4);
  CHECK(result.counts.loops == 0);
  REQUIRE(result.singular_points.size() == 2);
  for (const auto& point : result.singular_points) {
    CHECK(point.kind == SurfaceSingularity::crossing);
    CHECK(point.half_branches == 4);
    CHECK(point.certified);
    CHECK(std::fabs(std::fabs(point.at.point[0]) - 3.2) < 1e-12);
    CHECK(std::fabs(std::fabs(point.at.point[2]) - 2.4) < 1e-12);
  }
  for (const SurfaceComponent& curve : result.components) {
    CHECK(curve.certified);
    CHECK(curve.start.kind == BranchEndKind::singular);
    CHECK(curve.end.kind == BranchEndKind::singular);
    CHECK(curve.start.singular_point != curve.end.singular_point);
  }
  // Radius R, centres (0, +-r, 0).
  check_distances(result, [](const Point& p) {
    return std::min(distance_to_circle(p, {0, 3, 0}, {0.6, 0, -0.8}, 5),
                    distance_to_circle(p, {0, -3, 0}, {0.6, 0, -0.8}, 5));
  });
  CHECK(std::fabs(total_length(result) - 20 * pi) < 1e-3);
}

TEST_CASE("surface and equation: sections of a torus") {
  const SurfaceResult around = solve(whole(torus), "z");
  CHECK(around.counts.loops == 2);
  check_distances(around, [](const Point& p) {
    return std::min(distance_to_circle(p, {0, 0, 0}, {0, 0, 1}, 8), distance_to_circle(p, {0, 0, 0}, {0, 0, 1}, 2));
  });
  const SurfaceResult meridians = solve(whole(torus), "y");
  CHECK(meridians.counts.loops == 2);
  check_distances(meridians, [](const Point& p) {
    return std::min(distance_to_circle(p, {5, 0, 0}, {0, 1, 0}, 3), distance_to_circle(p, {-5, 0, 0}, {0, 1, 0}, 3));
  });
  // The tangent plane on top touches along a circle, that at the inner equator crosses itself.
  const SurfaceResult top = solve(whole(torus), "z - 3");
  CHECK(top.status == Status::certified);
  REQUIRE(top.counts.loops == 1);
  CHECK(top.components.front().tangential);
  const SurfaceResult lemniscate = solve(whole(torus), "x - 2");
  CHECK(lemniscate.status == Status::certified);
  CHECK(lemniscate.counts.curves == 2);
  REQUIRE(lemniscate.singular_points.size() == 1);
  CHECK(lemniscate.singular_points.front().kind == SurfaceSingularity::crossing);
  for (const SurfaceComponent& half : lemniscate.components) {
    CHECK(half.certified);
    CHECK(half.start.singular_point == half.end.singular_point);
  }
  const SurfaceResult sphere_around = solve(whole(torus), "x^2 + y^2 + z^2 - 25");
  CHECK(sphere_around.status == Status::certified);
  CHECK(sphere_around.counts.loops == 2);
  // (rho - 5)^2 + z^2 = 9 and rho^2 + z^2 = 25: rho = 41/10.
  const double height = std::sqrt(25 - 4.1 * 4.1);
  check_distances(sphere_around, [&](const Point& p) {
    return std::min(distance_to_circle(p, {0, 0, height}, {0, 0, 1}, 4.1),
                    distance_to_circle(p, {0, 0, -height}, {0, 0, 1}, 4.1));
  });
}

TEST_CASE("surface and equation: conic sections") {
  // The whole cone x^2 + y^2 = z^2, every point once.
  const SurfaceResult ellipse = solve(whole(cone), "2*z - x - 2");
  CHECK(ellipse.status == Status::certified);
  CHECK(ellipse.counts.loops == 1);
  CHECK(ellipse.components.size() == 1);
  // Foci of the projection along z: the apex and (4/3, 0); sum of the distances 8/3.
  for (const auto& point : ellipse.components.front().points) {
    const Point& p = point.point;
    CHECK(std::fabs(length(p[0], p[1]) + length(p[0] - 4.0 / 3, p[1]) - 8.0 / 3) < 1e-5);
  }
  const SurfaceResult parabola = solve(whole(cone), "z - x - 1");
  CHECK(parabola.status == Status::certified);
  REQUIRE(parabola.counts.curves == 1);
  CHECK(parabola.components.front().start.kind == BranchEndKind::infinity);
  CHECK(parabola.components.front().end.kind == BranchEndKind::infinity);
  const SurfaceResult hyperbola = solve(whole(cone), "x - 1");
  CHECK(hyperbola.status == Status::certified);
  CHECK(hyperbola.counts.curves == 2);
  for (const auto& [equation, result] : {std::pair("parabola", &parabola), std::pair("hyperbola", &hyperbola)}) {
    const std::string named = equation;
    CAPTURE(named);
    for (const SurfaceComponent& curve : result->components)
      for (const auto& point : curve.points) {
        const auto& [x, y, z] = point.point;
        const double size = std::max(1.0, std::fabs(z));
        CHECK(std::fabs(equation[0] == 'p' ? y * y - 2 * x - 1 : z * z - y * y - 1) < 1e-8 * size * size);
      }
  }
  const SurfaceResult lines = solve(whole(cone), "3*x - 4*y");
  CHECK(lines.status == Status::certified);
  CHECK(lines.counts.curves == 4);
  REQUIRE(lines.singular_points.size() == 1);
  CHECK(lines.singular_points.front().kind == SurfaceSingularity::crossing);
  CHECK(std::isnan(lines.singular_points.front().at.parameters[0]));
  CHECK(lines.singular_points.front().at.parameters[1] == 0);
  const SurfaceResult point = solve(whole(cone), "2*z - x");
  CHECK(point.status == Status::certified);
  CHECK(point.counts.curves == 0);
  REQUIRE(point.counts.points == 1);
  CHECK(point.components.front().points.front().point == Point{0, 0, 0});
}

TEST_CASE("surface and equation: Viviani's curve crosses itself once") {
  const SurfaceResult result = solve(patch(cylinder, {-3, 3}, {-3, 3}), "x^2 + y^2 + z^2 - 4", 1e-8);
  CHECK(result.status == Status::certified);
  CHECK(result.counts.curves == 4);
  REQUIRE(result.singular_points.size() == 1);
  const auto& crossing = result.singular_points.front();
  CHECK(crossing.kind == SurfaceSingularity::crossing);
  CHECK(crossing.at.point == Point{2, 0, 0});
  for (const SurfaceComponent& curve : result.components) {
    CHECK(curve.certified);
    CHECK((curve.start.kind == BranchEndKind::border) != (curve.end.kind == BranchEndKind::border));
    for (const auto& at : curve.points) {
      // x = 1 + cos 2a, y = sin 2a, z = 2 sin a.
      const auto& [x, y, z] = at.point;
      const double a = std::asin(std::clamp(0.5 * z, -1.0, 1.0));
      CHECK(length(x - 1 - std::cos(2 * a), std::fabs(y) - std::fabs(std::sin(2 * a))) < 1e-7);
    }
  }
  const SurfaceResult all = solve(whole(cylinder), "x^2 + y^2 + z^2 - 4");
  CHECK(all.status == Status::certified);
  CHECK(all.counts.curves == 2);
  CHECK(all.counts.singular == 1);
  check_distances(all, [](const Point& p) {
    // Newton's method from the nearest of many points would say less than both equations do.
    return std::max(std::fabs(length(p[0] - 1, p[1]) - 1), std::fabs(length(p[0], p[1], p[2]) - 2));
  });
}

TEST_CASE("surface and equation: contacts, common parts, nothing") {
  const SurfaceResult tangent = solve(patch(sphere, {-1, 1}, {Rational(1) / Rational(5), 5}), "x - 1");
  CHECK(tangent.status == Status::certified);
  CHECK(tangent.components.size() == 1);
  REQUIRE(tangent.counts.points == 1);
  CHECK(tangent.components.front().tangential);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(std::fabs(tangent.components.front().points.front().point[k] - (k == 0 ? 1 : 0)) <
          tangent.components.front().error);
  REQUIRE(tangent.singular_points.size() == 1);
  CHECK(tangent.singular_points.front().kind == SurfaceSingularity::contact);
  CHECK(tangent.singular_points.front().half_branches == 0);

  const SurfaceResult part = solve(patch(sphere, {0, 1}, {1, 2}), "x^2 + y^2 + z^2 - 1");
  CHECK(part.status == Status::infinite);
  REQUIRE(part.counts.overlaps == 1);
  CHECK(part.components.front().points.size() == 4);
  CHECK(part.components.front().points[2].parameters[0] == 1);
  CHECK(part.components.front().points[2].parameters[1] == 2);
  CHECK(solve(whole(sphere), "(x^2 + y^2 + z^2 - 1)*(x - y)").counts.overlaps == 1);

  for (const std::string far : {"x - 2", "x^2 + y^2 + (z-3)^2 - 1", "x^2 + y^2 + z^2 + 1", "x^2 + y^2 + z^2 - 2"}) {
    CAPTURE(far);
    const SurfaceResult nothing = solve(whole(sphere), far);
    CHECK(nothing.status == Status::certified);
    CHECK(nothing.components.empty());
    CHECK(nothing.singular_points.empty());
  }
  CHECK_THROWS_AS(solve(whole(sphere), "1"), InvalidInput);
}

TEST_CASE("surface and equation: points to which a curve of parameters is mapped") {
  // The south pole is v = 0 for every u; the plane touches there.
  const SurfaceResult pole = solve(whole(sphere), "z + 1");
  CHECK(pole.status == Status::certified);
  CHECK(pole.components.size() == 1);
  REQUIRE(pole.counts.points == 1);
  CHECK(pole.components.front().points.front().point == Point{0, 0, -1});
  CHECK(std::isnan(pole.components.front().points.front().parameters[0]));
  // The pole from which the sphere is projected is two lines of parameters, which meet.
  const std::vector<std::string> projected{"2*u", "2*v", "u^2 + v^2 - 1", "1 + u^2 + v^2"};
  const SurfaceResult two_lines = solve(whole(projected), "z - 1");
  CHECK(two_lines.status == Status::certified);
  CHECK(two_lines.components.size() == 1);
  REQUIRE(two_lines.counts.points == 1);
  CHECK(two_lines.singular_points.size() == 1);
  CHECK(two_lines.components.front().points.front().point == Point{0, 0, 1});
  CHECK(std::isnan(two_lines.components.front().points.front().parameters[0]));
  CHECK(std::isnan(two_lines.components.front().points.front().parameters[1]));
  // On the border of a patch it is no point of its own where a curve ends there.
  const SurfaceResult meridian = solve(patch(sphere, {-1, 1}, {0, 1}), "4*y - 3*x");
  CHECK(meridian.status == Status::certified);
  CHECK(meridian.components.size() == 1);
  CHECK(meridian.counts.curves == 1);
  CHECK(meridian.singular_points.empty());
  const SurfaceResult sides = solve(patch(sphere, {-1, 1}, {0, 1}), "x");
  CHECK(sides.status == Status::certified);
  CHECK(sides.counts.curves == 2);
  CHECK(sides.components.size() == 2);
  CHECK(sides.singular_points.empty());
}

TEST_CASE("surface and equation: the graph of a function has the singularity of its plane curve") {
  struct Case {
    std::string curve;
    std::size_t curves, loops, points;
    SurfaceSingularity kind;
    std::size_t half_branches;
  };
  const Case cases[]{{"y^2 - x^3", 2, 0, 0, SurfaceSingularity::cusp, 2},
                     {"y^2 - x^2 - x^3", 3, 0, 0, SurfaceSingularity::crossing, 4},
                     {"x^2 + y^2 + x^3", 1, 0, 1, SurfaceSingularity::contact, 0},
                     {"y^2 - x^4", 4, 0, 0, SurfaceSingularity::cusp, 4},
                     {"y*(y^2 - 3*x^2)", 6, 0, 0, SurfaceSingularity::cusp, 6},
                     {"(x^2 + y^2)^2 - x^2 + y^2", 2, 0, 0, SurfaceSingularity::crossing, 4}};
  for (const Case& given : cases) {
    CAPTURE(given.curve);
    const SurfaceResult result = solve(patch(plane, {-2, 2}, {-3, 3}), given.curve + " + z");
    CHECK(result.counts.curves == given.curves);
    CHECK(result.counts.loops == given.loops);
    CHECK(result.counts.points == given.points);
    REQUIRE(result.singular_points.size() == 1);
    CHECK(result.singular_points.front().kind == given.kind);
    CHECK(result.singular_points.front().half_branches == given.half_branches);
    CHECK(result.singular_points.front().at.point == Point{0, 0, 0});
    for (const SurfaceComponent& component : result.components)
      if (!component.certified) CHECK_FALSE(component.reason.empty());
    if (given.kind == SurfaceSingularity::crossing) CHECK(result.status == Status::certified);
  }
}

TEST_CASE("surface and equation: the error is a bound next to a cusp, too") {
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    for (const unsigned power : {3U, 5U}) {
      const SurfaceResult result =
          solve(patch(plane, {-1, 1}, {-2, 2}), "y^2 - x^" + std::to_string(power) + " + z", tolerance);
      REQUIRE(result.components.size() == 2);
      for (const SurfaceComponent& half : result.components) {
        if (!half.certified) continue;
        double largest = 0;
        for (std::size_t i = 1; i < half.points.size(); ++i)
          for (const double share : {0.0, 0.3, 0.5, 0.9}) {
            const Point& p = half.points[i - 1].point;
            const Point& q = half.points[i].point;
            const double x = std::max(0.0, (1 - share) * p[0] + share * q[0]);
            const double y = (1 - share) * p[1] + share * q[1];
            largest = std::max(largest, std::fabs(std::fabs(y) - std::pow(x, 0.5 * power)));
          }
        // Measured along y, which is at most sqrt(1 + slope^2) times as far.
        CHECK(largest <= std::sqrt(1 + 0.25 * power * power) * half.error);
      }
    }
  }
}

TEST_CASE("surface and equation: factors at infinity are left out with a warning") {
  // (1/u, v/u, v) on x z - y - z = 0 is - u^2 v = 0: the line v = 0, twice to infinity.
  const SurfaceResult result = solve(patch({"1", "v", "u*v", "u"}, {-1, 2}, {-1, 1}), "x*z - y - z");
  CHECK(result.status == Status::certified);
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings.front().find("the factor u of the equation") == 0);
  REQUIRE(result.counts.curves == 2);
  CHECK(result.components.size() == 2);
  CHECK(result.singular_points.empty());
  for (const SurfaceComponent& line : result.components) {
    CHECK(line.certified);
    CHECK((line.start.kind == BranchEndKind::infinity) != (line.end.kind == BranchEndKind::infinity));
    for (const auto& point : line.points) {
      CHECK(point.point[1] == 0);
      CHECK(point.point[2] == 0);
    }
  }
}

TEST_CASE("surface and equation: base points are infinity where the weight vanishes most") {
  // A whole plane over two projective lines: (u, v) = (inf, inf) is a base point, to which the parabola goes.
  const SurfaceResult parabola = solve(whole(plane), "y - x^2");
  CHECK(parabola.status == Status::certified);
  REQUIRE(parabola.counts.curves == 1);
  CHECK(parabola.components.front().start.kind == BranchEndKind::infinity);
  CHECK(parabola.components.front().end.kind == BranchEndKind::infinity);
  for (const auto& point : parabola.components.front().points)
    CHECK(std::fabs(point.point[1] - point.point[0] * point.point[0]) < 1e-4 * std::max(1.0, point.point[1]));
  // u = 2 v through the base point (0, 0) of (u : v : u + v : u + v^2) stays finite there.
  const SurfaceResult finite = solve(patch({"u", "v", "u + v", "u + v^2"}, {-1, 1}, {-1, 1}), "x - 2*y");
  CHECK(finite.status == Status::numeric);
  for (const SurfaceComponent& curve : finite.components) {
    const bool ends_there = curve.start.kind == BranchEndKind::unknown || curve.end.kind == BranchEndKind::unknown;
    CHECK(curve.certified != ends_there);
    CHECK(curve.reason.empty() != ends_there);
  }
}

TEST_CASE("surface and equation: both orders say the same") {
  for (const auto& [surface, equation] :
       {std::pair(patch(cylinder, {-3, 3}, {-3, 3}), "x^2 + y^2 + z^2 - 4"), std::pair(whole(torus), "3*x - 4*z"),
        std::pair(patch(sphere, {-1, 1}, {Rational(1) / Rational(2), 2}), "x + y + 2*z - 1")}) {
    const std::string named = equation;
    CAPTURE(named);
    Options options;
    options.tolerance = 1e-5;
    const SurfaceResult first = intersect_surface_surface({surface, in_space(equation)}, options, Context());
    const SurfaceResult second = intersect_surface_surface({in_space(equation), surface}, options, Context());
    CHECK(first.status == second.status);
    REQUIRE(first.components.size() == second.components.size());
    REQUIRE(first.singular_points.size() == second.singular_points.size());
    for (std::size_t i = 0; i < first.components.size(); ++i) {
      const SurfaceComponent& a = first.components[i];
      const SurfaceComponent& b = second.components[i];
      REQUIRE(a.points.size() == b.points.size());
      CHECK(a.start.side == std::array<int, 4>{b.start.side[2], b.start.side[3], b.start.side[0], b.start.side[1]});
      CHECK(a.end.transition == b.end.transition);
      for (std::size_t k = 0; k < a.points.size(); k += 50) {
        CHECK(a.points[k].point == b.points[k].point);
        CHECK(a.points[k].parameters[0] == b.points[k].parameters[2]);
        CHECK(a.points[k].parameters[1] == b.points[k].parameters[3]);
        CHECK(std::isnan(b.points[k].parameters[0]));
      }
    }
  }
}

TEST_CASE("surface and equation: ends say how the border crosses the surface") {
  const SurfaceResult result = solve(patch(plane, {-2, 2}, {-1, 1}), "x - y/2");
  REQUIRE(result.counts.curves == 1);
  const SurfaceComponent& line = result.components.front();
  // On v = -1 and v = 1 the parameter u runs to greater values of x - y / 2.
  CHECK(line.start.side == std::array<int, 4>{0, -1, 0, 0});
  CHECK(line.end.side == std::array<int, 4>{0, 1, 0, 0});
  CHECK(line.start.transition == intersect::Transition::out);
  CHECK(line.end.transition == intersect::Transition::out);
  const SurfaceResult turned = solve(patch(plane, {-2, 2}, {-1, 1}), "y/2 - x");
  CHECK(turned.components.front().start.transition == intersect::Transition::in);
}
