// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include <support/branch_graphs.hpp>
#include <support/traced_arcs.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/arc_tracing.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

using Point = std::array<double, 3>;
using Distance = std::function<double(const Point&)>;

const PatchText ground{"u", "v", "0"};
const CellBox everything{{0, 0, 0, 0}, {1, 1, 1, 1}};

/// Follows every arc of the intersection.
std::vector<TracedArc> trace_all(const NetPair& nets, double tolerance) {
  const Context context;
  const BranchGraph graph = branch_graph(nets);
  REQUIRE(graph.open.empty());
  ArcTracer tracer(nets.first, nets.second);
  std::vector<TracedArc> arcs;
  for (const CellArc& arc : graph.arcs)
    arcs.push_back(tracer.trace(graph.points[arc.from], graph.points[arc.to], arc.box, tolerance, context));
  return arcs;
}

void check_arcs(const NetPair& nets, const Distance& distance) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    CAPTURE(tolerance);
    const std::vector<TracedArc> arcs = trace_all(nets, tolerance);
    REQUIRE_FALSE(arcs.empty());
    for (const TracedArc& arc : arcs) {
      CHECK(arc.proven);
      CHECK(arc.points.size() >= 2);
      CHECK(arc.error <= tolerance);
      CHECK(farthest(arc, distance) <= arc.error + 1e-15);
    }
  }
}

CrossingPoint at(double u, double v) {
  CrossingPoint point;
  point.parameters = {u, v, u, v};
  point.radius = 1e-12;
  return point;
}

}  // namespace

TEST_CASE("Arc tracing: lines and circles within the error, and that within the tolerance") {
  check_arcs({ground, {"u", "v", "u + 2*v - 1"}},
             [](const Point& p) { return std::hypot((p[0] + 2 * p[1] - 1) / std::sqrt(5.0), p[2]); });
  const auto circle = [](double radius, double height) {
    return [radius, height](const Point& p) {
      return std::hypot(std::hypot(p[0] - 0.5, p[1] - 0.5) - radius, p[2] - height);
    };
  };
  check_arcs({ground, {"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"}}, circle(1.0 / 3, 0));
  check_arcs({{"u", "v", "(u - 1/2)^2 + (v - 1/2)^2"}, {"u", "v", "1/2 - (u - 1/2)^2 - (v - 1/2)^2"}},
             circle(0.5, 0.25));
  // A rational quarter of a cylinder, cut by a tilted plane: x^2 + y^2 = 1, z = x / 2 + 1/4.
  const NetPair cylinder({"1 - u^2", "2*u", "v*(1 + u^2)", "1 + u^2"}, {"2*u - 1/2", "2*v - 1/2", "u"});
  check_arcs(cylinder, [](const Point& p) {
    // From the curve it is at least as far as from the cylinder and from the plane.
    return std::max(std::fabs(std::hypot(p[0], p[1]) - 1), std::fabs(p[2] - p[0] / 2 - 0.25) / std::sqrt(1.25));
  });
}

TEST_CASE("Arc tracing: the arc is never farther from its polyline than the error") {
  const NetPair nets(ground, {"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"});
  for (const double tolerance : {1e-2, 1e-4, 1e-7})
    for (const TracedArc& arc : trace_all(nets, tolerance))
      for (std::size_t i = 0; i + 1 < arc.points.size(); ++i) {
        const Point& a = arc.points[i].point;
        const Point& b = arc.points[i + 1].point;
        const double chord = std::hypot(a[0] - b[0], a[1] - b[1]);
        constexpr double radius = 1.0 / 3;
        // Height of the arc over its chord.
        const double height = radius - std::sqrt(radius * radius - 0.25 * chord * chord);
        CHECK(height <= arc.error + 1e-15);
      }
}

TEST_CASE("Arc tracing: points are on both patches, from one crossing point to the other") {
  const NetPair nets({"u", "v", "u^2 + v^2"}, {"v", "u", "1/3 + u*v/2"});
  const Context context;
  const BranchGraph graph = branch_graph(nets);
  REQUIRE_FALSE(graph.arcs.empty());
  ArcTracer tracer(nets.first, nets.second);
  for (const CellArc& cell : graph.arcs) {
    const TracedArc arc = tracer.trace(graph.points[cell.from], graph.points[cell.to], cell.box, 1e-6, context);
    REQUIRE(arc.proven);
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(arc.points.front().parameters[k] == doctest::Approx(graph.points[cell.from].parameters[k]));
      CHECK(arc.points.back().parameters[k] == doctest::Approx(graph.points[cell.to].parameters[k]));
    }
    for (const TracedPoint& point : arc.points) {
      const auto& [u, v, s, t] = point.parameters;
      CHECK(std::fabs(u - t) < 1e-13);
      CHECK(std::fabs(v - s) < 1e-13);
      CHECK(std::fabs(u * u + v * v - 1.0 / 3 - s * t / 2) < 1e-13);
      CHECK(std::fabs(point.point[0] - u) < 1e-15);
      CHECK(std::fabs(point.point[2] - u * u - v * v) < 1e-13);
    }
  }
}

TEST_CASE("Arc tracing: never proven between points of different arcs, or beyond the box") {
  const Context context;
  for (const char* gap : {"1/4", "1/64", "1/4096"}) {
    const std::string distance = gap;
    CAPTURE(distance);
    const NetPair lines(ground, {"u", "v", "(u - 1/2)*(u - 1/2 - " + distance + ")"});
    const double other = 0.5 + (distance == "1/4" ? 0.25 : distance == "1/64" ? 1.0 / 64 : 1.0 / 4096);
    ArcTracer tracer(lines.first, lines.second);
    CHECK(tracer.trace(at(0.5, 0), at(0.5, 1), everything, 1e-3, context).proven);
    CHECK_FALSE(tracer.trace(at(0.5, 0), at(other, 1), everything, 1e-3, context).proven);
    CHECK_FALSE(tracer.trace(at(0.5, 0.25), at(other, 0.25), everything, 1e-3, context).proven);
  }
  const NetPair circle(ground, {"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"});
  ArcTracer tracer(circle.first, circle.second);
  const CellBox half{{0, 0, 0, 0}, {0.5, 1, 0.5, 1}};
  CHECK(tracer.trace(at(0.5, 5.0 / 6), at(0.5, 1.0 / 6), half, 1e-6, context).proven);
  const CellBox quarter{{0.25, 0.5, 0.25, 0.5}, {0.5, 1, 0.5, 1}};
  CHECK_FALSE(tracer.trace(at(0.5, 5.0 / 6), at(0.5, 1.0 / 6), quarter, 1e-6, context).proven);
  Context cancelled;
  cancelled.cancel();
  CHECK_THROWS_AS(tracer.trace(at(0.5, 5.0 / 6), at(0.5, 1.0 / 6), half, 1e-12, cancelled), LimitReached);
}

TEST_CASE("Arc tracing: near a goal") {
  const Context context;
  const NetPair circle(ground, {"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 - 1/9"});
  for (const double near : {1e-1, 1e-3, 1e-6}) {
    const TracedArc arc =
        ArcTracer(circle.first, circle.second)
            .trace_near(at(0.5, 5.0 / 6).parameters, at(5.0 / 6, 0.5).parameters, everything, near, 1e-7, context);
    CHECK(arc.proven);
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(std::fabs(arc.points.back().parameters[k] - (k % 2 == 0 ? 5.0 / 6 : 0.5)) < near);
  }
}
