// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/contact_curves.hpp>
#include <eliminant/bridge/contacts/crossing_branch.hpp>
#include <eliminant/bridge/contacts/crossing_tracing.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

/// A saddle and a patch that touches it along u = v; the branch u + v = 1 crosses there.
struct Pair {
  NetPair nets;
  ContactCurves curves{nets.first, nets.second, nets.exact_first, nets.exact_second};
  std::optional<CurveCrossing> crossing;

  explicit Pair(const std::string& weight = "1", bool exchanged = false)
      : nets(exchanged ? NetPair(touching(weight), saddle(weight)) : NetPair(saddle(weight), touching(weight))) {
    REQUIRE(curves.find({0.2, 0.2, 0.2, 0.2}, 0.2));
    crossing = curves.crossing({{0.495, 0.495, 0.495, 0.495}, {0.505, 0.505, 0.505, 0.505}});
    REQUIRE(crossing);
  }
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

  static PatchText saddle(const std::string& weight) { return {"u", "v", "u*v", weight}; }
  static PatchText touching(const std::string& weight) { return {"u", "v", "u*v + (u - v)^2*(u + v - 1)", weight}; }
  const ContactCurve& curve() const { return curves.curves()[0]; }
};

double distance_to_branch(const std::array<double, 4>& at) {
  return std::max(std::fabs(at[0] + at[1] - 1), std::fabs(at[2] + at[3] - 1));
}

}  // namespace

TEST_CASE("Crossing branch: points are within their errors, however near to the crossing") {
  for (const std::string weight : {"1", "1 + u/2 + v/3"}) {
    CAPTURE(weight);
    const Pair pair(weight);
    CrossingBranch branch(pair.curve(), *pair.crossing);
    // The branch in the coordinates of the crossing, whose directions are its own.
    const auto near = pair.crossing->coordinates_of({0.504, 0.496});
    for (const double scale : {1.0, -1.0, 0.1, 1e-2, 1e-3, 1e-4}) {
      CAPTURE(scale);
      const auto point = branch.at(1.01 * scale * near[0], scale * near[1], 1e-13);
      REQUIRE(point);
      CHECK(point->error < 1e-13);
      CHECK(distance_to_branch(point->parameters) < 1e-12);
      CHECK(point->point[0] ==
            doctest::Approx(point->parameters[0] /
                            (weight == "1" ? 1 : 1 + point->parameters[0] / 2 + point->parameters[1] / 3)));
    }
  }
}

TEST_CASE("Crossing tracing: the polyline is within its error of the branch, down to 1e-11") {
  for (const bool exchanged : {false, true}) {
    CAPTURE(exchanged);
    const Pair pair("1", exchanged);
    CrossingPoint from;
    from.parameters = {0.504, 0.496, 0.504, 0.496};
    for (const double tolerance : {1e-4, 1e-6, 1e-9, 1e-11}) {
      CAPTURE(tolerance);
      const TracedArc arc = trace_to_crossing(pair.curve(), from, *pair.crossing, tolerance, Context());
      CHECK(arc.proven);
      CHECK(arc.error <= 1.1 * tolerance);
      REQUIRE(arc.points.size() >= 2);
      for (const TracedPoint& point : arc.points) {
        CHECK(distance_to_branch(point.parameters) <= 2 * arc.error + 1e-15);
        CHECK(std::fabs(point.point[0] + point.point[1] - 1) <= 2 * arc.error + 1e-15);
      }
      CHECK(std::fabs(arc.points.back().parameters[0] - 0.5) <= arc.error);
    }
  }
}

TEST_CASE("Crossing tracing: from no point of the branch nothing is proven") {
  const Pair pair;
  CrossingPoint from;
  // Beyond the box.
  from.parameters = {0.9, 0.1, 0.9, 0.1};
  CHECK_FALSE(trace_to_crossing(pair.curve(), from, *pair.crossing, 1e-6, Context()).proven);
}
