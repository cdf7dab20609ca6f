// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <support/branch_graphs.hpp>
#include <support/traced_arcs.hpp>

#include <eliminant/bridge/branches/zoomed_tracing.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

using Point = std::array<double, 3>;

const std::array<symbolic::Rational, 3> nowhere{};

/// All arcs of the first contact.
template <class Distance>
void check_contact(const NetPair& nets, Distance distance) {
  const Context context;
  const SurfaceContactProver prover(nets.first, nets.second, nets.exact_first, nets.exact_second);
  const BranchGraph graph = branch_graph(nets, &prover);
  REQUIRE(graph.contacts.size() == 1);
  const CellContact& contact = graph.contacts.front();
  std::size_t arcs = 0;
  for (const double tolerance : {1e-4, 1e-7, 1e-10})
    for (const CellArc& cell : graph.arcs) {
      if (!cell.contact) continue;
      ++arcs;
      CAPTURE(tolerance);
      const TracedArc arc = trace_to_contact({nets.first, nets.second, nets.exact_first, nets.exact_second, nowhere},
                                             graph.points[cell.from], contact, tolerance, context);
      CHECK(arc.proven);
      CHECK(arc.error <= tolerance);
      CHECK(arc.points.back().parameters == contact.contact.rounded);
      CHECK(farthest(arc, distance) <= arc.error + 1e-15);
    }
  CHECK(arcs == 12);
}

}  // namespace

TEST_CASE("Zoomed tracing: to a crossing of a line and a parabola, to any tolerance") {
  // The line u = 1/2 and the parabola v - 1/2 = -(u - 1/2)^2 cross at (1/2, 1/2).
  const auto distance = [](const Point& p) {
    const double x = p[0] - 0.5;
    return std::min(std::fabs(x), std::fabs(p[1] - 0.5 + x * x) / std::hypot(1, 2 * x));
  };
  check_contact({{"u", "v", "0"}, {"u", "v", "(u - 1/2)*(v - 1/2 + (u - 1/2)^2)"}}, distance);
  // The contact is no double.
  check_contact({{"u", "v", "0"}, {"u", "v", "(u - 1/3)*(v - 1/3 + (u - 1/3)^2)"}}, [&](const Point& p) {
    return distance({p[0] + 1.0 / 6, p[1] + 1.0 / 6, p[2]});
  });
}

TEST_CASE("Zoomed tracing: to the pinch point of Whitney's umbrella, from both sides") {
  // (0, v) and (0, -v) are (0, 0, v^2).
  const ExactNet exact = patch_net({"u*v", "u", "v^2"}, square(1));
  const ControlNet net = in_doubles(exact);
  const ParameterRectangle rectangle{{0.25, 0.25}, {0.75, 0.75}};
  const auto pinch = pinch_point_in(net, rectangle);
  REQUIRE(pinch);
  const Context context;
  for (const double tolerance : {1e-4, 1e-7, 1e-10})
    for (const double v : {0.25, 0.75}) {
      CAPTURE(tolerance);
      const TracedArc arc = trace_to_pinch_point({net, net, exact, exact, nowhere}, {0.5, v, 0.5, 1 - v}, *pinch,
                                                 rectangle, tolerance, context);
      CHECK(arc.proven);
      CHECK(arc.error <= tolerance);
      CHECK(farthest(arc, [](const Point& p) { return std::hypot(p[0], p[1]); }) <= arc.error + 1e-15);
      CHECK(arc.points.front().point[2] == doctest::Approx(0.25));
      const TracedPoint& end = arc.points.back();
      for (std::size_t k = 0; k < 4; ++k) CHECK(std::fabs(end.parameters[k] - 0.5) <= pinch->radius);
      CHECK(std::fabs(end.point[2]) <= 1e-15);
    }
}

TEST_CASE("Zoomed tracing: a small loop, nearly tangential everywhere, beyond what doubles reach without") {
  // A circle of radius 2^-14 in the cap of a paraboloid.
  const NetPair nets({"u", "v", "0"}, {"u", "v", "(u - 1/2)^2 + (v - 1/3)^2 - 1/268435456"});
  const BranchGraph graph = branch_graph(nets);
  REQUIRE(graph.open.empty());
  REQUIRE(graph.arcs.size() >= 2);
  const Context context;
  for (const CellArc& arc : graph.arcs) {
    constexpr double tolerance = 1e-12;
    const TracedArc traced = trace_in_zoom({nets.first, nets.second, nets.exact_first, nets.exact_second, nowhere},
                                           graph.points[arc.from], graph.points[arc.to], arc.box, tolerance, context);
    CHECK(traced.proven);
    CHECK(traced.error <= tolerance);
    CHECK(farthest(traced, [](const Point& p) {
            return std::hypot(std::hypot(p[0] - 0.5, p[1] - 1.0 / 3) - 0x1p-14, p[2]);
          }) <= traced.error + 1e-16);
  }
}
