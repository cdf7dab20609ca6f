// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <eliminant/intersect/whole_surfaces/whole_surfaces.hpp>
#include <support/bezoutian_data.hpp>

using namespace eliminant;
using intersect::BranchEndKind;
using intersect::Status;
using intersect::SurfaceComponent;
using intersect::SurfaceComponentKind;
using intersect::SurfacePoint;
using intersect::SurfaceResult;
using intersect::SurfaceSingularity;
using symbolic::RationalSurface;

namespace {

using Coordinates = std::vector<std::string>;
using Equation = std::function<double(double, double, double)>;

const Coordinates cylinder{"u^2+1", "1-u^2", "2*u", "v*(u^2+1)"};
const Coordinates cone{"u^2+1", "v*(1-u^2)", "2*u*v", "v*(u^2+1)"};
const Coordinates sphere{"(u^2+1)*(v^2+1)", "2*v*(1-u^2)", "4*u*v", "(1-v^2)*(u^2+1)"};
/// Radii 2 and 1, about the axis of z.
const Coordinates torus{"(u^2+1)*(v^2+1)", "(1-u^2)*(v^2+3)", "2*u*(v^2+3)", "2*v*(u^2+1)"};
/// Radii 5 and 3.
const Coordinates large_torus{"(u^2+1)*(v^2+1)", "(1-u^2)*(8*v^2+2)", "2*u*(8*v^2+2)", "6*v*(u^2+1)"};
const Coordinates biquadratic{"1", "-u^2*v^2 - 5*u^2*v + 2*u^2 + 3*u*v^2 + u*v + 7*u + 6*v^2 - 2*v - 1",
                              "9*u^2*v^2 - 5*u^2*v + 2*u*v^2 + 4*u*v + u - 7*v^2 + 9*v", "u^2*v + 2*u*v - 2*v^2"};

RationalSurface first(const Coordinates& coordinates) {
  return test::weight_first(coordinates, test::first_parameters());
}
RationalSurface second(const Coordinates& coordinates) {
  return test::weight_first(coordinates, test::second_parameters());
}

SurfaceResult intersection(const Coordinates& a, const Coordinates& b) {
  const Context context;
  return intersect::intersect_whole_surfaces(first(a), second(b), {}, context);
}
SurfaceResult self_intersection(const Coordinates& a) {
  const Context context;
  return intersect::intersect_whole_surface_with_itself(first(a), {}, context);
}

void check_counts(const SurfaceResult& result, unsigned long curves, unsigned long loops, unsigned long points,
                  unsigned long singular) {
  CHECK(result.counts.curves == curves);
  CHECK(result.counts.loops == loops);
  CHECK(result.counts.points == points);
  CHECK(result.counts.singular == singular);
}

/// Every point lies on the surfaces f = 0; chords are no farther from it than `error` allows, |grad f| <= slope.
void check_on(const SurfaceResult& result, const Equation& f, double slope) {
  REQUIRE_FALSE(result.components.empty());
  for (const SurfaceComponent& component : result.components) {
    CHECK(component.certified);
    REQUIRE(component.points.size() > 1);
    for (std::size_t k = 0; k < component.points.size(); ++k) {
      const auto& p = component.points[k].point;
      const bool at_end = k == 0 || k + 1 == component.points.size();
      REQUIRE(std::fabs(f(p[0], p[1], p[2])) <= (at_end ? 1e-5 : 1e-9) * slope);
      if (k == 0) continue;
      const auto& q = component.points[k - 1].point;
      const double between = f((p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2);
      REQUIRE(std::fabs(between) <= slope * component.error);
    }
    if (component.kind == SurfaceComponentKind::loop)
      CHECK(component.points.front().parameters == component.points.back().parameters);
  }
}

double distance(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}

/// From the nearest point of a polyline in (u, v, s, t), with both preimages exchanged for a self-intersection.
double distance_to(const SurfaceResult& result, const std::array<double, 4>& parameters) {
  double least = INFINITY;
  for (const SurfaceComponent& component : result.components)
    for (const SurfacePoint& point : component.points) least = std::min(least, distance(point.parameters, parameters));
  if (result.problem == "self_intersection")
    for (const SurfaceComponent& component : result.components)
      for (const SurfacePoint& point : component.points) {
        const auto& [u, v, s, t] = point.parameters;
        least = std::min(least, distance({s, t, u, v}, parameters));
      }
  return least;
}

}  // namespace

TEST_CASE("Whole surfaces: two cylinders of different radii whose axes meet have two loops in common") {
  const SurfaceResult result = intersection(cylinder, {"s^2+1", "t*(s^2+1)", "2/3-2*s^2/3", "4*s/3"});
  CHECK(result.status == Status::certified);
  check_counts(result, 0, 2, 0, 0);
  check_on(
      result, [](double x, double y, double) { return x * x + y * y - 1; }, 2.1);
  check_on(
      result, [](double, double y, double z) { return y * y + z * z - 4.0 / 9; }, 1.5);
}

TEST_CASE("Whole surfaces: two cylinders of one radius have two ellipses in common that cross twice") {
  const SurfaceResult result = intersection(cylinder, {"s^2+1", "t*(s^2+1)", "1-s^2", "2*s"});
  CHECK(result.status == Status::certified);
  check_counts(result, 4, 0, 0, 2);
  check_on(
      result, [](double x, double, double z) { return (x - z) * (x + z); }, 4.3);
  for (const auto& point : result.singular_points) {
    CHECK(point.kind == SurfaceSingularity::crossing);
    CHECK(point.half_branches == 4);
    CHECK(std::fabs(point.at.point[0]) <= point.radius);
    CHECK(std::fabs(std::fabs(point.at.point[1]) - 1) <= point.radius);
    CHECK(std::fabs(point.at.point[2]) <= point.radius);
  }
}

TEST_CASE("Whole surfaces: a bitangent plane cuts a torus in Villarceau's circles") {
  const SurfaceResult result = intersection(large_torus, {"1", "s", "t", "3/4*s"});
  CHECK(result.status == Status::certified);
  check_counts(result, 4, 0, 0, 2);
  // Circles of radius 5 about (0, -3, 0) and (0, 3, 0).
  check_on(
      result,
      [](double x, double y, double z) {
        const double square = x * x + z * z;
        return std::min(std::fabs(std::hypot(std::sqrt(square), y - 3) - 5),
                        std::fabs(std::hypot(std::sqrt(square), y + 3) - 5));
      },
      1.01);
  for (const auto& point : result.singular_points) {
    CHECK(point.kind == SurfaceSingularity::crossing);
    CHECK(std::fabs(std::fabs(point.at.point[0]) - 3.2) <= 1e-5);
    CHECK(std::fabs(point.at.point[1]) <= 1e-5);
    CHECK(std::fabs(std::fabs(point.at.point[2]) - 2.4) <= 1e-5);
  }
}

TEST_CASE("Whole surfaces: two spheres by angles show their circle once for every pair of parameters") {
  const SurfaceResult result = intersection(sphere, {"s^2*t^2+s^2+t^2+1", "s^2*t^2/2-2*s^2*t+s^2/2+t^2/2+2*t+1/2",
                                                     "s^2*t^2/3+s^2/3+4*s*t+t^2/3+1/3", "-s^2*t^2+s^2-t^2+1"});
  CHECK(result.status == Status::certified);
  check_counts(result, 0, 4, 0, 0);
  check_on(
      result, [](double x, double y, double) { return x + 2 * y / 3 - 13.0 / 36; }, 1.3);
  check_on(
      result, [](double x, double y, double z) { return x * x + y * y + z * z - 1; }, 2.1);
}

TEST_CASE("Whole surfaces: Viviani's curve crosses itself in one point") {
  // The poles of the sphere are on the axis of y, not on the curve; it gives each point two pairs of parameters.
  const Coordinates turned{sphere[0], sphere[1], sphere[3], sphere[2]};
  const SurfaceResult result = intersection(turned, {"s^2+1", "1", "s", "s^2*t+t"});
  CHECK(result.status == Status::certified);
  check_counts(result, 4, 0, 0, 2);
  check_on(
      result, [](double x, double y, double) { return x * x + y * y - x; }, 2.1);
  check_on(
      result, [](double x, double y, double z) { return x * x + y * y + z * z - 1; }, 2.1);
  for (const auto& point : result.singular_points) {
    CHECK(std::fabs(point.at.point[0] - 1) <= 1e-5);
    CHECK(point.half_branches == 4);
  }
}

TEST_CASE("Whole surfaces: planes cut a cone, a cylinder and a torus in closed curves") {
  const SurfaceResult ellipse = intersection(cone, {"1", "s", "t", "1/2*s+1"});
  CHECK(ellipse.status == Status::certified);
  check_counts(ellipse, 0, 1, 0, 0);
  check_on(
      ellipse, [](double x, double y, double z) { return x * x + y * y - z * z; }, 6);
  const SurfaceResult section = intersection(cylinder, {"1", "s", "t", "s+2*t+1/3"});
  CHECK(section.status == Status::certified);
  check_counts(section, 0, 1, 0, 0);
  check_on(
      section, [](double x, double y, double) { return x * x + y * y - 1; }, 2.1);
  const SurfaceResult two = intersection(torus, {"1", "s", "t", "s+2*t+1/3"});
  CHECK(two.status == Status::certified);
  check_counts(two, 0, 2, 0, 0);
  check_on(
      two, [](double x, double y, double z) { return z - x - 2 * y - 1.0 / 3; }, 2.5);
}

TEST_CASE("Whole surfaces: a plane that touches a torus from within cuts it in a figure eight") {
  const SurfaceResult result = intersection(torus, {"1", "1", "s", "t"});
  CHECK(result.status == Status::certified);
  check_counts(result, 2, 0, 0, 1);
  REQUIRE(result.singular_points.size() == 1);
  CHECK(result.singular_points[0].kind == SurfaceSingularity::crossing);
  for (const SurfaceComponent& component : result.components) {
    CHECK(component.start.kind == BranchEndKind::singular);
    CHECK(component.end.kind == BranchEndKind::singular);
  }
}

TEST_CASE("Whole surfaces: surfaces apart have nothing in common, and the same surface all") {
  const SurfaceResult apart = intersection(sphere, {"1", "s", "3", "t"});
  CHECK(apart.status == Status::certified);
  check_counts(apart, 0, 0, 0, 0);
  const SurfaceResult same = intersection(torus, {"(s^2+1)*(t^2+1)", "(1-s^2)*(t^2+3)", "2*s*(t^2+3)", "2*t*(s^2+1)"});
  CHECK(same.status == Status::infinite);
  CHECK(same.counts.overlaps == 1);
}

TEST_CASE("Whole surfaces: a point of contact in a pole of the parameters is not taken for nothing") {
  const SurfaceResult result = intersection(sphere, {"1", "s", "t", "1"});
  CHECK(result.status == Status::numeric);
  CHECK_FALSE(result.warnings.empty());
}

TEST_CASE("Whole surfaces: two polynomial biquadratic surfaces") {
  const Coordinates a{"1", "-3*u^2*v^2+4*u^2-2*u*v^2+u+2*v+4", "-2*u^2*v^2+2*u^2*v+u^2+4*u*v^2+2*u+2*v^2-v-4",
                      "u^2*v^2-u^2*v+4*u^2+4*u*v^2-2*u*v-u-2*v^2-4*v+4"};
  const Coordinates b{"1", "-2*s^2*t^2+3*s^2*t+4*s^2-3*s*t^2+2*s*t-3*t^2-3*t+4",
                      "-4*s^2*t^2+s^2*t-4*s^2+s*t^2+2*s*t-4*s+t^2+4*t+2",
                      "-s^2*t^2-s^2*t+4*s^2-3*s*t^2-s*t+2*s-4*t^2+t+3"};
  const SurfaceResult result = intersection(a, b);
  CHECK(result.status == Status::certified);
  check_counts(result, 4, 1, 0, 0);
  // All real common points with t = 1/3, from the kernel of the Bezoutian matrix.
  CHECK(distance_to(result, {-1.88073097426145, 0.906698416937559, 1.39650203955307, 1.0 / 3}) < 0.05);
  CHECK(distance_to(result, {-1.17457592441493, 0.391687249837263, 1.10352537561457, 1.0 / 3}) < 0.05);
  CHECK(distance_to(result, {0.697098437733672, -0.186438370679283, 0.821992341689900, 1.0 / 3}) < 0.05);
  CHECK(distance_to(result, {1.20579028327572, 0.120122905925527, -1.36894998177975, 1.0 / 3}) < 0.05);
}

TEST_CASE("Whole surfaces: the double curve of the biquadratic example") {
  const SurfaceResult result = self_intersection(biquadratic);
  CHECK(result.status == Status::certified);
  // The three nodes of D are double points at infinity; its triple points have three different lifts.
  CHECK(result.counts.excluded == 3);
  check_counts(result, 6, 0, 0, 4);
  for (const auto& point : result.singular_points) {
    CHECK(point.kind == SurfaceSingularity::pinch_point);
    CHECK(distance(point.at.parameters, {point.at.parameters[2], point.at.parameters[3], point.at.parameters[0],
                                         point.at.parameters[1]}) == 0);
    CHECK(point.radius < 1e-9);
  }
  for (const SurfaceComponent& component : result.components) {
    double reach = 0;
    for (const SurfacePoint& point : component.points)
      for (const double x : point.point) reach = std::max(reach, std::fabs(x));
    CHECK(component.error < 2e-6 * reach);
  }
  CHECK(std::count_if(result.components.begin(), result.components.end(),
                      [](const SurfaceComponent& component) { return component.mirrored; }) == 4);
  // The three branches through (-1.047..., -0.0488...) and two points with v = 1/3.
  const double u = -1.04709472340320;
  const double v = -0.0488563631290503;
  for (const auto& [l, k] : {std::array<double, 2>{-2.20613, -0.60581}, {-0.81603, 0.041031}, {0.959814, -0.44662}})
    CHECK(distance_to(result, {u, v + k, u + l, v}) < 0.05);
  CHECK(distance_to(result, {-2.65994590414546, 1.0 / 3 - 0.446982034584252, -2.65994590414546 + 2.65526834208386,
                             1.0 / 3}) < 0.05);
  CHECK(distance_to(result, {-1.25445052400207, 1.0 / 3 - 0.911631732407002, -1.25445052400207 + 1.38699708998631,
                             1.0 / 3}) < 0.05);
}

TEST_CASE("Whole surfaces: an embedded torus does not meet itself, Whitney's umbrella does in a half-line") {
  const SurfaceResult embedded = self_intersection(torus);
  CHECK(embedded.status == Status::certified);
  check_counts(embedded, 0, 0, 0, 0);
  const SurfaceResult umbrella = self_intersection({"1", "u*v", "v^2", "u"});
  check_counts(umbrella, 1, 0, 0, 1);
  REQUIRE(umbrella.components.size() == 1);
  CHECK(umbrella.components[0].mirrored);
  CHECK(umbrella.components[0].error < 1e-3);
  CHECK(umbrella.singular_points[0].radius < 1e-12);
  for (const SurfacePoint& point : umbrella.components[0].points) {
    CHECK(std::fabs(point.point[0]) < 1e-9);
    CHECK(point.point[1] > -1e-9);
    CHECK(std::fabs(point.point[2]) < 1e-9);
  }
}

TEST_CASE("Whole surfaces: exchanging the surfaces changes nothing") {
  const SurfaceResult result = intersection({"1", "u", "v", "u+2*v+1/3"}, {"s^2+1", "1-s^2", "2*s", "t*(s^2+1)"});
  const SurfaceResult exchanged = intersection(cylinder, {"1", "s", "t", "s+2*t+1/3"});
  CHECK(result.status == exchanged.status);
  CHECK(result.counts.loops == exchanged.counts.loops);
  CHECK(result.counts.curves == exchanged.counts.curves);
}

TEST_CASE("Whole surfaces: a branch through infinity is cut there once, also where tracing began") {
  const SurfaceResult result = intersection({"1", "-3*u*v+u+v-2", "-3*u*v-u+5*v+2", "u*v+u+3*v-3"},
                                            {"-3*s^2+4*s*t-5*s+2*t-3", "-2*s^2*t+5*s^2+2*s*t+5*s+2*t+2",
                                             "-4*s^2*t+3*s^2-4*s*t+2*s+4*t+3", "3*s^2-5*s*t+2*s"});
  CHECK(result.status == Status::certified);
  check_counts(result, 6, 0, 0, 0);
  for (const SurfaceComponent& component : result.components) {
    CHECK(component.start.kind == BranchEndKind::infinity);
    CHECK(component.end.kind == BranchEndKind::infinity);
    CHECK(std::isfinite(component.error));
  }
}
