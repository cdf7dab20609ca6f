// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/surface_surface.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::ParametricSurface;

namespace {

constexpr double tolerance = 1e-5;

/// Forms of one degree in u, v, w, on the triangle.
ParametricSurface triangle(const PatchText& text) {
  static const std::vector<std::string> names{"u", "v", "w"};
  std::vector<symbolic::Polynomial> forms;
  for (const std::string& coordinate : {text.x, text.y, text.z, text.w})
    forms.push_back(symbolic::parse_polynomial(coordinate, names));
  const symbolic::Interval unit{0, 1};
  return {{{symbolic::RationalSurface(symbolic::RationalSurface::Kind::triangular, std::move(forms)),
            symbolic::ParameterRegion{{unit, unit}, true}}}};
}

ParametricSurface tensor(const PatchText& text, const Sides& sides = unit_square()) { return {{patch(text, sides)}}; }

SurfaceResult solved(const ParametricSurface& first, const ParametricSurface& second) {
  Options options;
  options.tolerance = tolerance;
  return intersect_surface_surface({first, second}, options, Context());
}

SurfaceResult solved(const ParametricSurface& first, const std::string& equation) {
  Options options;
  options.tolerance = tolerance;
  const std::vector<std::string> names{"x", "y", "z"};
  return intersect_surface_surface({first, symbolic::parse_polynomial(equation, names)}, options, Context());
}

const std::string sum = "(u + v + w)";
const Sides large{symbolic::Interval{-3, 3}, symbolic::Interval{-3, 3}};

/// z = 27 u v w over the triangle of x = u, y = v: 0 on its sides, 1 in the middle.
ParametricSurface dome(const std::string& x = "u", const std::string& y = "v", const std::string& z = "27*u*v*w") {
  return triangle({x + "*" + sum + "^2", y + "*" + sum + "^2", z, sum + "^3"});
}

double height_of_dome(double x, double y) { return 27 * x * y * (1 - x - y); }

ParametricSurface plane(const std::string& z) { return tensor({"u", "v", z}, large); }

/// The octant of the unit sphere over u, v >= 0, u + v <= 1, with its border u + v = 1 inside the octant.
ParametricSurface spherical_triangle() {
  return triangle({"2*u*" + sum, "2*v*" + sum, sum + "^2 - u^2 - v^2", sum + "^2 + u^2 + v^2"});
}

/// Points of a component are where both maps say.
void check_parameters(const SurfaceComponent& component, const std::function<SpacePoint(double, double)>& map,
                      std::size_t index) {
  double gap = 0;
  for (const SurfacePoint& at : component.points) {
    const SpacePoint point = map(at.parameters[2 * index], at.parameters[2 * index + 1]);
    for (std::size_t k = 0; k < 3; ++k) gap = std::max(gap, std::fabs(point[k] - at.point[k]));
  }
  CHECK(gap < 1e-12);
}

}  // namespace

TEST_CASE("Triangular patches: a dome and a plane have one loop over all seams, in either order") {
  for (const bool exchanged : {false, true}) {
    const SurfaceResult result = exchanged ? solved(plane("1/2"), dome()) : solved(dome(), plane("1/2"));
    CHECK(summary(result) == "0 1 0 0 0 certified");
    REQUIRE(result.components.size() == 1);
    const SurfaceComponent& loop = result.components[0];
    CHECK(loop.error < 2 * tolerance);
    check_parameters(
        loop,
        [](double u, double v) {
          return SpacePoint{u, v, height_of_dome(u, v)};
        },
        exchanged ? 1 : 0);
    for (const SurfacePoint& at : loop.points) CHECK(std::fabs(at.point[2] - 0.5) < 1e-12);
    // It winds once around the top.
    double turned = 0;
    for (std::size_t i = 0; i + 1 < loop.points.size(); ++i) {
      const auto angle = [&](std::size_t k) {
        return std::atan2(loop.points[k].point[1] - 1.0 / 3, loop.points[k].point[0] - 1.0 / 3);
      };
      turned += std::remainder(angle(i + 1) - angle(i), 2 * std::acos(-1.0));
    }
    CHECK(std::fabs(turned) == doctest::Approx(2 * std::acos(-1.0)));
  }
}

TEST_CASE("Triangular patches: planes above, at and below the top of a dome") {
  CHECK(summary(solved(dome(), plane("11/10"))) == "0 0 0 0 0 certified");
  const SurfaceResult top = solved(dome(), plane("1"));
  CHECK(summary(top) == "0 0 1 0 1 certified");
  REQUIRE(top.singular_points.size() == 1);
  CHECK(top.singular_points[0].kind == SurfaceSingularity::contact);
  for (std::size_t k = 0; k < 2; ++k)
    CHECK(std::fabs(top.singular_points[0].at.parameters[k] - 1.0 / 3) <= top.singular_points[0].radius);
  CHECK(summary(solved(dome(), plane("999/1000"))) == "0 1 0 0 0 certified");
}

TEST_CASE("Triangular patches: a border in a plane is one curve, from corner to corner") {
  // The plane meets the dome where u + v = 1, and nowhere else.
  const SurfaceResult result = solved(dome(), plane("u + v - 1"));
  CHECK(summary(result) == "1 0 0 0 0 certified");
  REQUIRE(result.components.size() == 1);
  const SurfaceComponent& side = result.components[0];
  for (const BranchEnd* end : {&side.start, &side.end}) CHECK(end->third_side == std::array{true, false});
  CHECK(side.start.side[0] + side.end.side[0] == -1);
  CHECK(side.start.side[1] + side.end.side[1] == -1);
  CHECK(length_of(side) == doctest::Approx(std::sqrt(2)));
  CHECK(farthest(side, [](const SpacePoint& p) { return std::hypot(p[0] + p[1] - 1, p[2]); }) <= side.error);
}

TEST_CASE("Triangular patches: the curve is that of the same map as a tensor product, cut along u + v = 1") {
  const std::vector<std::array<std::string, 2>> heights{{"u*v*w + u^3/5 - v^3/7", "1/50"},
                                                        {"u^2*w - v^2*u", "1/30 - u/9"},
                                                        {"(u - v)*(u - w)*(v - w)", "1/90"},
                                                        {"u^3 - v*w*u + v^3 - w^3/3", "v/4 - 1/7"}};
  for (const auto& [height, other] : heights) {
    CAPTURE(height);
    const PatchText forms{"u*" + sum + "^2", "v*" + sum + "^2", height, sum + "^3"};
    std::string affine = height;
    for (std::size_t at = affine.find('w'); at != std::string::npos; at = affine.find('w'))
      affine.replace(at, 1, "(1-u-v)");
    const SurfaceResult cut = solved(triangle(forms), plane(other));
    const SurfaceResult whole = solved(tensor({"u", "v", affine}), plane(other));
    CHECK(cut.status == Status::certified);
    CHECK(whole.status == Status::certified);
    const auto apart = [](const SurfaceResult& result, const SpacePoint& at) {
      double nearest = INFINITY;
      for (const SurfaceComponent& component : result.components)
        for (std::size_t i = 0; i + 1 < component.points.size(); ++i) {
          const SpacePoint& p = component.points[i].point;
          const SpacePoint& q = component.points[i + 1].point;
          double dot = 0;
          double square = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            dot += (at[k] - p[k]) * (q[k] - p[k]);
            square += (q[k] - p[k]) * (q[k] - p[k]);
          }
          const double place = std::clamp(dot / square, 0.0, 1.0);
          nearest =
              std::min(nearest, std::hypot(p[0] + place * (q[0] - p[0]) - at[0], p[1] + place * (q[1] - p[1]) - at[1],
                                           p[2] + place * (q[2] - p[2]) - at[2]));
        }
      return nearest;
    };
    std::size_t inside = 0;
    for (const SurfaceComponent& component : whole.components)
      for (const SurfacePoint& point : component.points)
        if (point.parameters[0] + point.parameters[1] < 1) {
          ++inside;
          CHECK(apart(cut, point.point) < 4 * tolerance * 2);
        }
    CHECK(inside > 20);
    for (const SurfaceComponent& component : cut.components) {
      for (const SurfacePoint& point : component.points) {
        CHECK(point.parameters[0] + point.parameters[1] < 1 + 1e-12);
        CHECK(apart(whole, point.point) < 4 * tolerance * 2);
      }
      // Ends are on borders of the triangle, and nowhere else.
      if (component.kind != SurfaceComponentKind::curve) continue;
      for (const bool at_start : {true, false}) {
        const BranchEnd& end = at_start ? component.start : component.end;
        const auto& at = (at_start ? component.points.front() : component.points.back()).parameters;
        CHECK(end.kind == BranchEndKind::border);
        CHECK((end.side[0] == -1) == (at[0] == 0));
        CHECK((end.side[1] == -1) == (at[1] == 0));
        CHECK(end.third_side[0] == (std::fabs(at[0] + at[1] - 1) < 1e-12));
        CHECK((end.side[0] == -1 || end.side[1] == -1 || end.third_side[0]));
      }
    }
  }
}

TEST_CASE("Triangular patches: a border crosses the other surface as the same border of a tensor product does") {
  // The plane crosses the borders v = 0 and u = 0; with the corners turned round, u + v = 1 and v = 0, and so on.
  const std::vector<std::array<std::string, 3>> turns{{"u", "v", "w"}, {"w", "u", "v"}, {"v", "w", "u"}};
  for (const std::string slope : {"3*u - 1", "1 - 3*u", "3*v - 1"}) {
    // Borders of x >= 0, y >= 0, x + y <= 1 by which corner is opposite: x = 0, y = 0, x + y = 1, each with its result.
    const auto transitions = [&](const std::array<std::string, 3>& names) {
      const PatchText text{names[0], names[1], "0", sum};
      const SurfaceResult result = solved(triangle(text), plane(slope));
      CHECK(summary(result) == "1 0 0 0 0 certified");
      std::array<std::optional<Transition>, 3> found;
      for (const SurfaceComponent& component : result.components)
        for (const BranchEnd* end : {&component.start, &component.end}) {
          const std::size_t border = end->side[0] == -1 ? 0 : end->side[1] == -1 ? 1 : 2;
          found[border] = end->transition;
        }
      return found;
    };
    // The same surface as a tensor product: u = 0 and v = 0 are two of its borders.
    const SurfaceResult square = solved(tensor({"u", "v", "0"}), plane(slope));
    std::array<std::optional<Transition>, 2> expected;
    for (const SurfaceComponent& component : square.components)
      for (const BranchEnd* end : {&component.start, &component.end})
        for (std::size_t k = 0; k < 2; ++k)
          if (end->side[k] == -1) expected[k] = end->transition;
    const auto own = transitions(turns[0]);
    for (std::size_t k = 0; k < 2; ++k) CHECK(own[k] == expected[k]);
    // One turn makes x = 0 the border v = 0, y = 0 the border u + v = 1, and x + y = 1 the border u = 0. Both are
    // followed from y = 0 to x + y = 1, or from x = 0, by u, v and v; the turned ones by v, u and v.
    const auto turned = transitions(turns[2]);
    const auto flipped = [](std::optional<Transition> t) {
      return !t || *t == Transition::touching ? t : *t == Transition::in ? Transition::out : Transition::in;
    };
    // x = v, y = w: x = 0 is v = 0, followed by u where y falls. y = 0 is u + v = 1, followed by v where x grows.
    // x + y = 1 is u = 0, followed by v where y falls.
    CHECK(turned[1] == flipped(own[0]));
    CHECK(turned[2] == own[1]);
    CHECK(turned[0] == flipped(own[2]));
  }
}

TEST_CASE("Triangular patches: circles on a rational triangle of the sphere") {
  for (const auto& [height, z] : {std::pair("1/2", 0.5), std::pair("1/4", 0.25), std::pair("9/10", 0.9)}) {
    CAPTURE(height);
    const SurfaceResult result = solved(spherical_triangle(), plane(height));
    CHECK(result.status == Status::certified);
    const double radius = std::sqrt(1 - z * z);
    CHECK(result.counts.curves == (z < 1.0 / 3 ? 2 : 1));
    for (const SurfaceComponent& component : result.components) {
      CHECK(component.kind == SurfaceComponentKind::curve);
      CHECK(farthest(component, [&, level = z](const SpacePoint& p) {
              return std::hypot(std::hypot(p[0], p[1]) - radius, p[2] - level);
            }) <= component.error + 1e-14);
    }
  }
  // Moved a little, the triangle meets itself in an arc of the plane in the middle.
  const ParametricSurface moved = triangle({"2*u*" + sum + " + (" + sum + "^2 + u^2 + v^2)/10", "2*v*" + sum,
                                            sum + "^2 - u^2 - v^2", sum + "^2 + u^2 + v^2"});
  const SurfaceResult two = solved(spherical_triangle(), moved);
  CHECK(two.status == Status::certified);
  for (const SurfaceComponent& component : two.components)
    CHECK(farthest(component, [](const SpacePoint& p) {
            return std::hypot(p[0] - 0.05, std::hypot(p[1], p[2]) - std::sqrt(1 - 0.0025));
          }) <= component.error + 1e-14);
}

TEST_CASE("Triangular patches: two triangles, and one in the plane of another") {
  const ParametricSurface flat = triangle({"u", "v", "0", sum});
  // (1/4, 1/4, -1), (1/4, 1/4, 1), (3, 3, 0): along x = y.
  const SurfaceResult crossing = solved(flat, triangle({"(u + v)/4 + 3*w", "(u + v)/4 + 3*w", "v - u", sum}));
  CHECK(summary(crossing) == "1 0 0 0 0 certified");
  CHECK(length_of(crossing.components.at(0)) == doctest::Approx(std::sqrt(2) / 4));
  CHECK(summary(solved(flat, triangle({"u", "v", sum, sum}))) == "0 0 0 0 0 certified");
  const SurfaceResult overlap = solved(flat, triangle({"u + w/4", "v + w/4", "0", sum}));
  CHECK(overlap.status == Status::infinite);
  // Twice the area of all parts: the smaller triangle is covered, up to its corner at (1/4, 1/4).
  double area = 0;
  for (const SurfaceComponent& part : overlap.components)
    for (std::size_t i = 0; i + 1 < part.points.size(); ++i) {
      const SpacePoint& p = part.points[i].point;
      const SpacePoint& q = part.points[i + 1].point;
      area += p[0] * q[1] - p[1] * q[0];
    }
  CHECK(std::fabs(area) == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("Triangular patches: with an equation, over all seams") {
  const SurfaceResult loop = solved(dome(), "z - 1/2");
  CHECK(summary(loop) == "0 1 0 0 0 certified");
  check_parameters(
      loop.components.at(0),
      [](double u, double v) {
        return SpacePoint{u, v, height_of_dome(u, v)};
      },
      0);
  const SurfaceResult arc = solved(dome(), "x^2 + y^2 - 1/9");
  CHECK(summary(arc) == "1 0 0 0 0 certified");
  REQUIRE(arc.components.size() == 1);
  const bool from_v = arc.components[0].start.side[1] == -1;
  const BranchEnd& on_v = from_v ? arc.components[0].start : arc.components[0].end;
  const BranchEnd& on_u = from_v ? arc.components[0].end : arc.components[0].start;
  CHECK(on_v.side == std::array{0, -1, 0, 0});
  CHECK(on_u.side == std::array{-1, 0, 0, 0});
  // Both parameters lead out of the circle.
  CHECK(on_v.transition == Transition::out);
  CHECK(on_u.transition == Transition::out);
  // A side of the triangle is a curve from corner to corner.
  CHECK(summary(solved(dome(), "x + z")) == "1 0 0 0 0 certified");
  // The third side, and 27 x y = 1, which crosses it twice.
  CHECK(summary(solved(dome(), "x + y + z - 1")) == "4 0 0 0 2 certified");
  const SurfaceResult all = solved(triangle({"u", "v", "0", sum}), "z");
  CHECK(all.status == Status::infinite);
}
