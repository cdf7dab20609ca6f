// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/corank_one_tracing.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

TEST_CASE("Corank one tracing: half-branches reach the contact within the tolerance") {
  // y = x^(m / 2) over the plane.
  for (const long m : {3, 4, 5, 6})
    for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
      CAPTURE(m);
      CAPTURE(tolerance);
      const NetPair nets({"u", "v", "0"}, {"u", "v", "(v - 1/2)^2 - (u - 1/2)^" + std::to_string(m)});
      const SurfaceContactProver prover(nets.first, nets.second, nets.exact_first, nets.exact_second);
      CellContact contact;
      contact.box = {{0.45, 0.45, 0.45, 0.45}, {0.55, 0.55, 0.55, 0.55}};
      const auto found = prover.find(contact.box);
      REQUIRE(found);
      contact.contact = *found;
      const auto around = prover.neighbourhood(*found, contact.box);
      REQUIRE(around);
      contact.around = *around;
      const double power = 0.5 * static_cast<double>(m);
      const double x = 0.05;
      CrossingPoint from;
      from.parameters = {0.5 + x, 0.5 - std::pow(x, power), 0.5 + x, 0.5 - std::pow(x, power)};
      const TracedArc arc = trace_to_corank_one(nets.first, nets.second, from, contact, tolerance, Context());
      CHECK(arc.proven);
      CHECK(arc.error <= tolerance);
      REQUIRE(arc.points.size() > 2);
      CHECK(arc.points.front().parameters[0] == doctest::Approx(0.5 + x));
      CHECK(arc.points.back().parameters == std::array{0.5, 0.5, 0.5, 0.5});
      // Vertices and middles of chords.
      const auto apart = [&](double u, double v) { return std::fabs(0.5 - v - std::pow(u - 0.5, power)); };
      for (std::size_t k = 1; k < arc.points.size(); ++k) {
        const auto& a = arc.points[k - 1].point;
        const auto& b = arc.points[k].point;
        CHECK(b[0] < a[0]);
        CHECK(apart(a[0], a[1]) <= 2 * tolerance);
        CHECK(apart(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])) <= 2 * tolerance);
      }
    }
}
