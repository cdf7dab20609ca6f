// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/contact_curves.hpp>
#include <eliminant/intersect/patches/contact_arcs.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

/// The arcs of the curve on which the second patch touches the saddle.
struct Arcs {
  NetPair nets;
  bridge::ContactCurves curves{nets.first, nets.second, nets.exact_first, nets.exact_second};
  ContactArcs found;

  explicit Arcs(const PatchText& second, const std::vector<bridge::CurveCrossing>& crossings = {})
      : nets({"u", "v", "u*v"}, second) {
    for (const double u : {0.2, 0.4, 0.6, 0.8})
      for (const double v : {0.2, 0.4, 0.6, 0.8})
        if (curves.curves().empty()) curves.find({u, v, u, v}, 0.4);
    REQUIRE(curves.curves().size() == 1);
    const bridge::ContactCurve& curve = curves.curves()[0];
    const PatchNets base =
        curve.swapped() ? PatchNets{nets.exact_second, nets.second} : PatchNets{nets.exact_first, nets.first};
    found = contact_arcs(curve, base, crossings, 1e-6, 1, Context());
  }
  Arcs(const Arcs&) = delete;
  Arcs& operator=(const Arcs&) = delete;
};

PatchText touching(const std::string& curve) { return {"u", "v", "u*v + (" + curve + ")^2"}; }

}  // namespace

TEST_CASE("Contact arcs: a line from border to border of both domains") {
  const Arcs arcs(touching("u - v/2 - 1/4"));
  CHECK(arcs.found.complete);
  REQUIRE(arcs.found.arcs.size() == 1);
  const ContactArc& arc = arcs.found.arcs[0];
  CHECK_FALSE(arc.closed);
  CHECK(arc.proven);
  CHECK(arc.error <= 1e-6);
  const bool upwards = arc.points.front().parameters[1] < 0.5;
  CHECK((upwards ? arc.start : arc.end).side == std::array<int, 4>{0, -1, 0, -1});
  CHECK((upwards ? arc.end : arc.start).side == std::array<int, 4>{0, 1, 0, 1});
  for (const bridge::TracedPoint& point : arc.points)
    CHECK(std::fabs(point.parameters[0] - point.parameters[1] / 2 - 0.25) <= 1e-6);
}

TEST_CASE("Contact arcs: cut where the curve leaves the domain of the other patch") {
  // The other patch covers 1/4 < x < 5/4.
  const Arcs arcs({"u + 1/4", "v", "(u + 1/4)*v + (v - 1/3)^2"});
  CHECK(arcs.found.complete);
  REQUIRE(arcs.found.arcs.size() == 1);
  const auto& points = arcs.found.arcs[0].points;
  CHECK(std::min(points.front().point[0], points.back().point[0]) == doctest::Approx(0.25));
  CHECK(std::max(points.front().point[0], points.back().point[0]) == doctest::Approx(1));
}

TEST_CASE("Contact arcs: loops are closed, and opened by a crossing") {
  const PatchText ellipse = touching("u^2 + 2*v^2 - u - 2*v + 13/20");
  const Arcs loop(ellipse);
  CHECK(loop.found.complete);
  REQUIRE(loop.found.arcs.size() == 1);
  CHECK(loop.found.arcs[0].closed);
  CHECK(loop.found.arcs[0].points.front().parameters == loop.found.arcs[0].points.back().parameters);

  bridge::CurveCrossing crossing;
  // A point of the ellipse: u = 1/2, 2 (v - 1/2)^2 = 1/10.
  const double v = 0.5 + std::sqrt(0.05);
  crossing.parameters = {0.5, v, 0.5, v};
  crossing.origin = {0.5, v};
  const Arcs opened(ellipse, {crossing});
  CHECK(opened.found.complete);
  REQUIRE(opened.found.arcs.size() == 1);
  CHECK_FALSE(opened.found.arcs[0].closed);
  CHECK(opened.found.arcs[0].start.crossing == 0);
  CHECK(opened.found.arcs[0].end.crossing == 0);
  CHECK(opened.found.arcs[0].points.front().parameters == crossing.parameters);
}

TEST_CASE("Contact arcs: a crossing away from the curve leaves them incomplete") {
  bridge::CurveCrossing crossing;
  crossing.parameters = {0.9, 0.1, 0.9, 0.1};
  CHECK_FALSE(Arcs(touching("u - v"), {crossing}).found.complete);
}
