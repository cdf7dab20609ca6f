// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/corank_one_branches.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

/// The plane under z = height, with a contact at (1/2, 1/2).
struct Pair {
  NetPair nets;
  CorankOnePatches patches;

  explicit Pair(const std::string& height) : nets({"u", "v", "0"}, {"u", "v", height}), patches(around(nets)) {}

  static CorankOnePatches around(const NetPair& nets) {
    std::array<Rational, 4> at;
    at.fill(ratio(1, 2));
    auto contact = corank_one_contact(nets.exact_first, nets.exact_second, at);
    REQUIRE(contact);
    auto result =
        CorankOnePatches::around(nets.first, nets.second, nets.exact_first, nets.exact_second, at, *std::move(contact));
    REQUIRE(result);
    return *std::move(result);
  }
  std::optional<CorankOneBranches> in_box(double half) const {
    CellBox box;
    box.lower.fill(0.5 - half);
    box.upper.fill(0.5 + half);
    return patches.in_box(nets.first, box);
  }
};

}  // namespace

TEST_CASE("Corank one branches: on which sides they are") {
  struct Case {
    std::string height;
    std::array<bool, 2> sides;
  };
  const std::string x = "(u - 1/2)";
  const std::string y = "(v - 1/2)";
  const std::vector<Case> cases{{y + "^2 - " + x + "^3", {true, false}},   {y + "^2 + 3*" + x + "^3", {false, true}},
                                {x + "^3 - 2*" + y + "^2", {true, false}}, {x + "^2 + " + y + "^3", {false, true}},
                                {y + "^2 - " + x + "^4", {true, true}},    {y + "^2 + " + x + "^4", {false, false}},
                                {y + "^2 + " + x + "^5", {false, true}},   {x + "^6 - " + y + "^2", {true, true}}};
  for (const Case& given : cases)
    for (const double half : {1.0 / 16, 1.0 / 256, 1.0 / 4096}) {
      CAPTURE(given.height);
      CAPTURE(half);
      const auto branches = Pair(given.height).in_box(half);
      REQUIRE(branches);
      CHECK(branches->sides == given.sides);
      CHECK(branches->half_branches() == (given.sides[0] ? 2U : 0U) + (given.sides[1] ? 2U : 0U));
    }
}

TEST_CASE("Corank one branches: nothing is claimed of a box with another contact or a turning point") {
  // z = y^2 - x^3 (x + 1/8): a loop ends at x = -1/8.
  const Pair pair("(v - 1/2)^2 - (u - 1/2)^3*(u - 3/8)");
  CHECK_FALSE(pair.in_box(3.0 / 16));
  CHECK(pair.in_box(1.0 / 64));
  // Another contact at u = 3/4.
  CHECK_FALSE(Pair("(v - 1/2)^2 + (u - 1/2)^4*(u - 3/4)^2").in_box(5.0 / 16));
}

TEST_CASE("Corank one branches: points, and bounds of how far a chord is from its arc") {
  // y = x^2 / 4 + x^(m / 2).
  for (const long m : {3, 4, 5, 6}) {
    CAPTURE(m);
    const Pair pair("(v - 1/2 - (u - 1/2)^2/4)^2 - (u - 1/2)^" + std::to_string(m));
    const auto branches = pair.in_box(1.0 / 16);
    REQUIRE(branches);
    const double power = 0.5 * static_cast<double>(m);
    for (const double far : {0.05, 1e-2, 1e-3, 1e-4}) {
      CAPTURE(far);
      const double height = std::pow(far, power);
      for (const double side : {1.0, -1.0}) {
        const auto point = pair.patches.point(*branches, {far, 0.8 * side * height, {far, 0}, 0});
        REQUIRE(point);
        CHECK(point->error < 1e-7 * height);
        // Beside the ridge as far as it is known, 1/4 x^2.
        CHECK(std::fabs(point->z - side * height) <= point->error + 1e-15 * height);
        const auto parameters = pair.patches.parameters(*branches, *point);
        CHECK(branches->half_branch(parameters[0] - 0.5, parameters[1] - 0.5, 0) == (side > 0 ? 0 : 1));
        // In the middle of a chord and of the last one.
        const auto place = [&](double x) { return 0.25 * x * x + side * std::pow(x, power); };
        const double near = 0.5 * far;
        const double middle = 0.75 * far;
        CHECK(branches->chord_error(near, far) >= 0.5 * std::fabs(place(middle) - 0.5 * (place(near) + place(far))));
        CHECK(branches->last_chord_error(far) >= 0.5 * std::fabs(place(near) - 0.5 * place(far)));
        CHECK(branches->last_chord_error(far) < 100 * (height + far * far));
      }
    }
  }
}

TEST_CASE("Corank one branches: a point that is too near to a half-branch is not assigned") {
  const auto branches = Pair("(v - 1/2)^2 - (u - 1/2)^3").in_box(1.0 / 16);
  REQUIRE(branches);
  CHECK(branches->half_branch(0.01, 0.001, 1e-6) == 0);
  CHECK(branches->half_branch(0.01, -0.001, 1e-6) == 1);
  CHECK_FALSE(branches->half_branch(0.01, 0.001, 1e-2));
  CHECK_FALSE(branches->half_branch(-0.01, 0.001, 1e-6));
}
