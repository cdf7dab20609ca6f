// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/surface_contact.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

/// A pair and its prover.
struct Pair {
  NetPair nets;
  SurfaceContactProver prover{nets.first, nets.second, nets.exact_first, nets.exact_second};

  Pair(const PatchText& a, const PatchText& b) : nets(a, b) {}
  Pair(const ExactNet& a, const ExactNet& b) : nets(a, b) {}
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;
};

const PatchText ground{"u", "v", "0"};

CellBox around(double u, double v, double half) {
  return {{u - half, v - half, u - half, v - half}, {u + half, v + half, u + half, v + half}};
}

SurfaceContact contact_at(const Rational& u, const Rational& v, double a, double b) {
  return {{u, v, u, v}, {a, b, a, b}};
}

/// The one on its own line of half-arcs.
std::size_t opposite(std::size_t half) { return half ^ 1U; }

}  // namespace

TEST_CASE("Surface contact: found at exact rational parameters, and alone where the Hessian is definite") {
  const std::array<std::array<long, 4>, 4> projective{{{9, 1, 0, 1}, {-1, 8, 1, 0}, {0, 1, 9, 2}, {1, 1, 0, 20}}};
  for (const std::string height : {"(u - 1/2)^2 + (v - 1/3)^2", "-3*(u - 1/2)^2 + (u - 1/2)*(v - 1/3) - (v - 1/3)^2",
                                   "(u - 1/2)^2 + 2*(v - 1/3)^2*u + (v - 1/3)^3"})
    for (const bool moved : {false, true}) {
      CAPTURE(height);
      ExactNet a = patch_net(ground);
      ExactNet b = patch_net({"u", "v", height});
      if (moved) transform(a, projective);
      if (moved) transform(b, projective);
      const Pair pair(a, b);
      const CellBox box = around(0.51, 0.34, 1.0 / 16);
      const auto contact = pair.prover.find(box);
      REQUIRE(contact);
      CHECK(contact->parameters == std::array<Rational, 4>{ratio(1, 2), ratio(1, 3), ratio(1, 2), ratio(1, 3)});
      CHECK(contact->rounded == std::array<double, 4>{0.5, 1.0 / 3, 0.5, 1.0 / 3});
      const auto there = pair.prover.neighbourhood(*contact, around(0.5, 0.34, 1.0 / 64));
      REQUIRE(there);
      CHECK_FALSE(there->crossing);
    }
}

TEST_CASE("Surface contact: two arcs cross where the Hessian is indefinite, each in its direction") {
  // Asymptotic directions (1, 0) and (0, 1); (2, 1) and (2, -1); (1, 1) and (1, 2).
  const std::vector<std::pair<std::string, std::array<std::array<double, 2>, 2>>> cases{
      {"(u - 1/2)*(v - 1/2)", {{{1, 0}, {0, 1}}}},
      {"(u - 1/2)^2 - 4*(v - 1/2)^2", {{{2, 1}, {2, -1}}}},
      {"(u - v)*(2*(u - 1/2) - (v - 1/2))/3 + (u - 1/2)^3/8", {{{1, 1}, {1, 2}}}},
  };
  for (const auto& crossing : cases) {
    const std::string& height = crossing.first;
    const auto& directions = crossing.second;
    CAPTURE(height);
    const Pair pair(ground, {"u", "v", height});
    const CellBox box = around(0.5, 0.5, 1.0 / 64);
    const auto contact = pair.prover.find(box);
    REQUIRE(contact);
    const auto there = pair.prover.neighbourhood(*contact, box);
    REQUIRE(there);
    CHECK(there->crossing);
    std::array<bool, 4> seen{};
    for (const auto& d : directions) {
      const auto forward = there->half_arc(0.01 * d[0], 0.01 * d[1]);
      const auto backward = there->half_arc(-0.01 * d[0], -0.01 * d[1]);
      REQUIRE(forward);
      REQUIRE(backward);
      CHECK(*backward == opposite(*forward));
      seen[*forward] = seen[*backward] = true;
      // Along it up to the sign.
      const auto& found = there->directions[*forward / 2];
      CHECK(std::fabs(found[0] * d[1] - found[1] * d[0]) < 1e-3);
    }
    CHECK(seen == std::array{true, true, true, true});
    // Halfway between them.
    const auto& [p, q] = there->directions;
    CHECK_FALSE(there->half_arc(p[0] + q[0], p[1] + q[1]));
    CHECK_FALSE(there->half_arc(p[0] - q[0], p[1] - q[1]));
  }
}

TEST_CASE("Surface contact: slope and chord error bound arcs that are known") {
  // (u - 1/2) (v - 1/2 + (u - 1/2)^2): the arcs u = 1/2 and the parabola v - 1/2 = -(u - 1/2)^2.
  const Pair pair(ground, {"u", "v", "(u - 1/2)*(v - 1/2 + (u - 1/2)^2)"});
  for (const double half : {1.0 / 32, 1.0 / 128, 1.0 / 1024}) {
    CAPTURE(half);
    const auto there =
        pair.prover.neighbourhood(contact_at(ratio(1, 2), ratio(1, 2), 0.5, 0.5), around(0.5, 0.5, half));
    REQUIRE(there);
    CHECK(there->crossing);
    // To (half, -half^2) from the contact the chord has that slope, and is a quarter of half^2 away in the middle.
    CHECK(there->slope >= half);
    CHECK(there->slope < 16 * half);
    CHECK(there->chord_error >= 0.25 * half * half / std::hypot(1, half));
    CHECK(there->chord_error < 200 * half * half);
  }
}

TEST_CASE("Surface contact: nothing is claimed of degenerate Hessians") {
  for (const std::string height : {"(u - 1/2)^2", "(u - 1/2)^2 + (v - 1/2)^4", "(u - 1/2)^2 - (v - 1/2)^3",
                                   "(u - 1/2)^3 - 3*(u - 1/2)*(v - 1/2)^2", "(u - 1/2)^2 - (v - 1/2)^4", "0"})
    for (const double half : {1.0 / 8, 1.0 / 64, 1.0 / 4096}) {
      CAPTURE(height);
      CAPTURE(half);
      const Pair pair(ground, {"u", "v", height});
      CHECK_FALSE(pair.prover.neighbourhood(contact_at(ratio(1, 2), ratio(1, 2), 0.5, 0.5), around(0.5, 0.5, half)));
    }
}

TEST_CASE("Surface contact: nor of boxes that hold more than one contact") {
  const Pair pair(ground, {"u", "v", "(u - 1/4)^2*(u - 3/4)^2 + (v - 1/2)^2"});
  const SurfaceContact left = contact_at(ratio(1, 4), ratio(1, 2), 0.25, 0.5);
  const CellBox both{{0.1875, 0.375, 0.1875, 0.375}, {0.8125, 0.625, 0.8125, 0.625}};
  CHECK_FALSE(pair.prover.neighbourhood(left, both));
  const auto alone = pair.prover.neighbourhood(left, around(0.25, 0.5, 1.0 / 32));
  REQUIRE(alone);
  CHECK_FALSE(alone->crossing);
}

TEST_CASE("Surface contact: none where the patches cross, miss each other, or touch along an irrational line") {
  for (const std::string height : {"u - 1/2", "(u - 1/2)^2 + (v - 1/2)^2 + 1/1000000000000",
                                   "(u - 1/2)^2 + (v - 1/2)^2 - 1/1000000000000000", "(u^2 - 1/3)^2"}) {
    CAPTURE(height);
    CHECK_FALSE(Pair(ground, {"u", "v", height}).prover.find(around(0.5, 0.5, 1.0 / 8)));
  }
  // Not one outside of the domain.
  CHECK_FALSE(Pair(ground, {"u", "v", "(u + 1/64)^2 + (v - 1/2)^2"}).prover.find(around(0.0625, 0.5, 1.0 / 16)));
}

TEST_CASE("Surface contact: at irrational parameters, on its own") {
  const Pair pair(ground, {"u", "v", "(u^2 - 1/3)^2 + (v - 1/2)^2"});
  const auto contact = pair.prover.find(around(0.5, 0.5, 1.0 / 8));
  REQUIRE(contact);
  CHECK(contact->rounded[0] == doctest::Approx(std::sqrt(1.0 / 3)));
  CHECK(contact->rounded[3] == 0.5);
  const auto neighbourhood = pair.prover.neighbourhood(*contact, around(0.57, 0.5, 1.0 / 32));
  REQUIRE(neighbourhood);
  CHECK_FALSE(neighbourhood->crossing);
}
