// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <support/text_surfaces.hpp>

#include <eliminant/intersect/sections/inverted_section.hpp>

using namespace eliminant;
using intersect::BranchEndKind;
using intersect::Options;
using intersect::Status;
using intersect::SurfaceComponent;
using intersect::SurfaceComponentKind;
using intersect::SurfacePoint;
using intersect::SurfaceResult;
using intersect::SurfaceSingularity;
using symbolic::Polynomial;
using symbolic::RationalSurface;
using test::cone;
using test::map_of;
using test::sphere_by_angles;
using test::Texts;

namespace {

const Texts plane_z0{"u", "v", "0", "1"};
const Texts plane_z1{"u", "v", "1", "1"};
const Texts& sphere = test::sphere_from_pole;
const Texts cylinder{"1 - u^2", "2*u", "v*(u^2 + 1)", "u^2 + 1"};
const Texts torus{"(1-u^2)*(v^2+3)", "2*u*(v^2+3)", "2*v*(u^2+1)", "(u^2+1)*(v^2+1)"};
const Texts monkey_saddle{"u", "v", "u^3 - 3*u*v^2", "1"};

/// x / w becomes x / w + shift.
Texts moved(Texts map, const std::array<std::string, 3>& shift) {
  for (std::size_t k = 0; k < 3; ++k) map[k] = "(" + map[k] + ") + (" + shift[k] + ")*(" + map[3] + ")";
  return map;
}

double value(const Polynomial& p, double u, double v) {
  double sum = 0;
  for (const auto& term : p.terms()) {
    const double coefficient = fmpq_get_d(term.coefficient.get());
    sum += coefficient * std::pow(u, static_cast<double>(term.exponents[0])) *
           std::pow(v, static_cast<double>(term.exponents[1]));
  }
  return sum;
}

/// Both pairs of parameters, where they are finite, are those of the point.
void check_parameters(const RationalSurface& first, const RationalSurface& second, const SurfacePoint& at) {
  for (const std::size_t index : {0U, 1U}) {
    const double u = at.parameters[2 * index];
    const double v = at.parameters[2 * index + 1];
    if (!(std::fabs(u) < 100 && std::fabs(v) < 100)) continue;
    const std::vector<Polynomial>& x = (index == 0 ? first : second).coordinates();
    const double w = value(x[3], u, v);
    for (std::size_t k = 0; k < 3; ++k) {
      const double size = std::max(1.0, std::fabs(at.point[k]));
      REQUIRE(std::fabs(value(x[k], u, v) / w - at.point[k]) < 1e-5 * size);
    }
  }
}

/// In both orders; the result of the first.
SurfaceResult intersection(const Texts& a, const Texts& b) {
  const RationalSurface first = map_of(a);
  const RationalSurface second = map_of(b);
  Options options;
  options.tolerance = 1e-6;
  const auto result = intersect_by_inversion(first, second, options, Context());
  const auto exchanged = intersect_by_inversion(second, first, options, Context());
  REQUIRE(result);
  REQUIRE(exchanged);
  CHECK(result->status == Status::certified);
  CHECK(result->counts.curves == exchanged->counts.curves);
  CHECK(result->counts.loops == exchanged->counts.loops);
  CHECK(result->counts.points == exchanged->counts.points);
  CHECK(result->counts.singular == exchanged->counts.singular);
  for (const SurfaceComponent& component : result->components) {
    CHECK(component.certified);
    for (std::size_t i = 0; i < component.points.size(); i += std::max<std::size_t>(1, component.points.size() / 16))
      check_parameters(first, second, component.points[i]);
  }
  return *result;
}

void check_counts(const SurfaceResult& result, const std::array<unsigned long, 4>& expected) {
  CHECK(result.counts.curves == expected[0]);
  CHECK(result.counts.loops == expected[1]);
  CHECK(result.counts.points == expected[2]);
  CHECK(result.counts.singular == expected[3]);
}

void check_tangential(const SurfaceResult& result, std::size_t expected) {
  CHECK(static_cast<std::size_t>(std::count_if(result.components.begin(), result.components.end(),
                                               [](const auto& c) { return c.tangential; })) == expected);
}

using Distance = std::function<double(const std::array<double, 3>&)>;

void check_distances(const SurfaceResult& result, const Distance& distance) {
  for (const SurfaceComponent& component : result.components)
    for (const SurfacePoint& point : component.points) {
      const double size = std::max({1.0, std::fabs(point.point[0]), std::fabs(point.point[1])});
      REQUIRE(distance(point.point) <= component.error + 1e-13 * size);
    }
}

}  // namespace

TEST_CASE("Inverted section: cones that touch along generators, through the apex") {
  // x^2 + y^2 = z^2 and x^2 + 2 y^2 = z^2: both lines x = z, x = -z in the plane y = 0.
  const SurfaceResult one_apex = intersection(cone, {"v*(2 - u^2)", "2*u*v", "v*(u^2 + 2)", "u^2 + 2"});
  check_counts(one_apex, {4, 0, 0, 1});
  check_tangential(one_apex, 4);
  check_distances(one_apex, [](const auto& p) {
    return std::hypot(p[1], std::fabs(std::fabs(p[0]) - std::fabs(p[2])) / std::sqrt(2));
  });
  CHECK(one_apex.singular_points.front().kind == SurfaceSingularity::crossing);
  CHECK(one_apex.singular_points.front().at.point == std::array<double, 3>{0, 0, 0});
  // Moved along a generator, parallel cones touch along that.
  const SurfaceResult parallel = intersection(cone, moved(cone, {"1", "0", "1"}));
  check_tangential(parallel, parallel.components.size());
  CHECK(parallel.counts.curves == parallel.components.size());
  check_distances(parallel, [](const auto& p) { return std::hypot(p[1], (p[0] - p[2]) / std::sqrt(2)); });
}

TEST_CASE("Inverted section: spheres and tori touch along circles") {
  // The circle of the tube around (2, 0, 0) in the plane y = 0, through the pole of the stereographic sphere.
  const SurfaceResult tube = intersection(torus, moved(sphere, {"2", "0", "0"}));
  check_counts(tube, {0, 1, 0, 0});
  check_tangential(tube, 1);
  check_distances(tube, [](const auto& p) { return std::hypot(p[1], std::hypot(p[0] - 2, p[2]) - 1); });
  // Two tori, one on the other one.
  const SurfaceResult tori = intersection(torus, moved(torus, {"0", "0", "2"}));
  check_counts(tori, {0, 1, 0, 0});
  check_tangential(tori, 1);
  check_distances(tori, [](const auto& p) { return std::hypot(std::hypot(p[0], p[1]) - 2, p[2] - 1); });
  // A sphere by angles covers the outer equator twice.
  Texts large = sphere_by_angles;
  for (std::size_t k = 0; k < 3; ++k) large[k] = "3*" + large[k];
  const SurfaceResult equator = intersection(torus, large);
  check_counts(equator, {0, 2, 0, 0});
  check_tangential(equator, 2);
  check_distances(equator, [](const auto& p) { return std::hypot(std::hypot(p[0], p[1]) - 3, p[2]); });
}

TEST_CASE("Inverted section: contacts in the pole of a projection have no parameters there") {
  const SurfaceResult plane = intersection(sphere, plane_z1);
  check_counts(plane, {0, 0, 1, 1});
  CHECK(plane.singular_points.front().at.point == std::array<double, 3>{0, 0, 1});
  CHECK(std::isnan(plane.singular_points.front().at.parameters[0]));
  CHECK(plane.singular_points.front().at.parameters[2] == 0);
  // Both poles are the point of contact.
  Texts larger = sphere;
  for (std::size_t k = 0; k < 3; ++k) larger[k] = "2*(" + larger[k] + ")";
  const SurfaceResult poles = intersection(sphere, moved(larger, {"0", "0", "-1"}));
  check_counts(poles, {0, 0, 1, 1});
  CHECK(poles.singular_points.front().kind == SurfaceSingularity::contact);
  for (const double parameter : poles.singular_points.front().at.parameters) CHECK(std::isnan(parameter));
}

TEST_CASE("Inverted section: a circle through the pole of a sphere is one loop") {
  for (const Texts& plane : {Texts{"0", "u", "v", "1"}, Texts{"u", "v", "1 - u", "1"}, Texts{"v", "v", "u", "1"}}) {
    CAPTURE(plane[2]);
    const SurfaceResult circle = intersection(sphere, plane);
    check_counts(circle, {0, 1, 0, 0});
    check_distances(circle, [](const auto& p) { return std::fabs(std::hypot(p[0], p[1], p[2]) - 1); });
    // By angles every point has two pairs of parameters, which are exchanged on the way through one of the poles.
    const bool through_both = plane[2] != "1 - u";
    check_counts(intersection(sphere_by_angles, plane), {0, through_both ? 2UL : 1UL, 0, 0});
  }
}

TEST_CASE("Inverted section: a curve through the pole of a sphere is not cut there") {
  // Viviani's curve on the sphere of radius 2; its crossing is (2, 0, 0).
  Texts larger = sphere;
  for (std::size_t k = 0; k < 3; ++k) larger[k] = "2*(" + larger[k] + ")";
  const SurfaceResult viviani = intersection(larger, moved(cylinder, {"1", "0", "0"}));
  check_counts(viviani, {2, 0, 0, 1});
  CHECK(viviani.singular_points.front().kind == SurfaceSingularity::crossing);
  CHECK(viviani.singular_points.front().at.point == std::array<double, 3>{2, 0, 0});
}

TEST_CASE("Inverted section: planes cut a monkey saddle in curves to infinity") {
  const SurfaceResult lines = intersection(monkey_saddle, plane_z0);
  check_counts(lines, {6, 0, 0, 1});
  for (const SurfaceComponent& line : lines.components)
    CHECK((line.start.kind == BranchEndKind::infinity) != (line.end.kind == BranchEndKind::infinity));
  CHECK(lines.singular_points.front().half_branches == 6);
  const SurfaceResult oblique = intersection(monkey_saddle, {"u", "v", "u + 1", "1"});
  check_counts(oblique, {3, 0, 0, 0});
  check_distances(oblique, [](const auto& p) { return std::fabs(p[2] - p[0] - 1) / std::sqrt(2); });
}
