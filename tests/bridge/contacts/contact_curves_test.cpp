// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/contact_curves.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

struct Pair {
  NetPair nets;
  ContactCurves curves{nets.first, nets.second, nets.exact_first, nets.exact_second};

  Pair(const PatchText& a, const PatchText& b) : nets(a, b) {}
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;
};

CellBox around(double u, double v, double half) {
  return {{u - half, v - half, u - half, v - half}, {u + half, v + half, u + half, v + half}};
}

const PatchText saddle{"u", "v", "u*v"};

}  // namespace

TEST_CASE("Contact curves: recognised and proven, lines, conics and parabolas, irrational points included") {
  for (const std::string curve :
       {"u - 1/3", "v - 2*u/7 - 1/5", "u*v + u/3 - 1/4", "u^2 + 2*v^2 - u - 2*v + 13/20", "v - 1/4 - u^2/2"}) {
    CAPTURE(curve);
    Pair pair(saddle, {"u", "v", "u*v + (" + curve + ")^2*(2 + u)"});
    // Somewhere not far.
    bool found = false;
    for (const double v : {0.3, 0.5, 0.7})
      for (const double u : {0.3, 0.5, 0.7}) found = found || pair.curves.find({u, v, u, v}, 0.3);
    REQUIRE(found);
    CHECK(pair.curves.curves().size() == 1);
    const static std::vector<std::string> names{"u", "v"};
    CHECK(pair.curves.curves()[0].relation().curve == symbolic::parse_polynomial(curve, names).primitive_part());
  }
}

TEST_CASE("Contact curves: a point of contact, a transversal curve and a near miss are none") {
  for (const std::string height : {"(u - 1/2)^2 + (v - 1/3)^2", "u - v", "(u - 1/2)^2 + 1/100000"}) {
    CAPTURE(height);
    Pair pair(saddle, {"u", "v", "u*v + " + height});
    for (const double v : {0.3, 0.5, 0.7})
      for (const double u : {0.3, 0.5, 0.7}) CHECK_FALSE(pair.curves.find({u, v, u, v}, 0.3));
    CHECK(pair.curves.curves().empty());
  }
}

TEST_CASE("Contact curves: explain boxes around them, and no box with a point of another branch") {
  // The branch u + v = 1 crosses the line u = v in (1/2, 1/2).
  Pair pair(saddle, {"u", "v", "u*v + (u - v)^2*(u + v - 1)"});
  REQUIRE(pair.curves.find({0.2, 0.2, 0.2, 0.2}, 0.2));
  CHECK(pair.curves.explains(around(0.25, 0.25, 0.02)));
  CHECK(pair.curves.explains(around(0.76, 0.75, 0.02)));
  for (const double half : {0.25, 0.0625, 0.01, 0.001}) CHECK_FALSE(pair.curves.explains(around(0.5, 0.5, half)));
  // A point of the branch beside the curve.
  for (const double half : {0.25, 0.0625, 0.02}) CHECK_FALSE(pair.curves.explains(around(0.51, 0.49, half)));
  CHECK(pair.curves.holds({ratio(1, 3), ratio(1, 3), ratio(1, 3), ratio(1, 3)}));
  CHECK_FALSE(pair.curves.holds({ratio(1, 3), ratio(1, 3), ratio(1, 3), ratio(2, 3)}));
}

TEST_CASE("Contact curves: a branch that crosses is proven, to nearly all digits of doubles") {
  // In boxes of very different sizes.
  for (const double half : {0.005, 0.001, 0.0001}) {
    CAPTURE(half);
    Pair pair(saddle, {"u", "v", "u*v + (u - v)^2*(u + v - 1)"});
    REQUIRE(pair.curves.find({0.2, 0.2, 0.2, 0.2}, 0.2));
    const auto crossing = pair.curves.crossing(around(0.5, 0.5, half));
    REQUIRE(crossing);
    CHECK(crossing->inside);
    for (const double parameter : crossing->parameters) CHECK(std::fabs(parameter - 0.5) <= crossing->radius);
    CHECK(crossing->radius < 1e-11);
    CHECK_FALSE(pair.curves.crossing(around(0.25, 0.25, 0.01)));
  }
}

TEST_CASE("Contact curves: the crossing of rational patches is where the branch meets the curve") {
  // The same height over a weight: the branch u + v = 1 again.
  Pair pair({"u", "v", "u*v", "1 + u/2"}, {"u", "v", "u*v + (u - v)^2*(u + v - 1)", "1 + u/2"});
  REQUIRE(pair.curves.find({0.2, 0.2, 0.2, 0.2}, 0.2));
  const auto crossing = pair.curves.crossing(around(0.5, 0.5, 0.005));
  REQUIRE(crossing);
  for (const double parameter : crossing->parameters) CHECK(std::fabs(parameter - 0.5) <= crossing->radius);
  CHECK(crossing->radius < 1e-11);
}

TEST_CASE("Contact curves: along a border, with patches on both sides of it or on one") {
  const PatchText first{"u", "v", "u^2"};
  struct Seam {
    PatchText second;
    std::array<int, 4> sides;
    bool explained;
  };
  // Tangent, with equal curvature and on the same side; with equal curvature on the same side more would have to be
  // known.
  const std::vector<Seam> seams{{{"1 + u", "v", "1 + 2*u - 3*u^2"}, {1, 0, -1, 0}, true},
                                {{"1 + v", "1 - u", "1 + 2*v + v^2 - v^3"}, {1, 0, 0, -1}, true},
                                {{"1 - u", "v", "1 - 2*u + 2*u^2"}, {1, 0, -1, 0}, true},
                                {{"1 - u", "v", "1 - 2*u + u^2 - u^3"}, {1, 0, -1, 0}, false}};
  for (const Seam& seam : seams) {
    CAPTURE(seam.second.x);
    CAPTURE(seam.second.z);
    Pair pair(first, seam.second);
    CHECK_FALSE(pair.curves.is_along(0, 1));
    REQUIRE(pair.curves.find_along(0, 1, 0, 1));
    CHECK(pair.curves.is_along(0, 1));
    CHECK(pair.curves.curves().size() == 1);
    CHECK(pair.curves.curves()[0].sides_along() == seam.sides);
    CHECK(pair.curves.find_along(0, 1, 0, 1));
    CHECK(pair.curves.curves().size() == 1);
    const auto& curve = pair.curves.curves()[0];
    const auto middle =
        curve.parameters_at(curve.swapped() ? std::array<double, 2>{0, 0.4} : std::array<double, 2>{1, 0.4});
    CellBox box;
    for (std::size_t k = 0; k < 4; ++k) {
      box.lower[k] = middle[k] - 0.02;
      box.upper[k] = middle[k] + 0.02;
    }
    CHECK(pair.curves.explains(box) == seam.explained);
  }
  // A common border without a common tangent plane, and one that is not there.
  Pair edge(first, {"1 + u", "v", "1 + u"});
  CHECK_FALSE(edge.curves.find_along(0, 1, 0, 1));
  CHECK_FALSE(edge.curves.find_along(0, -1, 0, 1));
}

TEST_CASE(
    "Contact curves: nearly parallel patches on different sides of a border in common are explained, on one side they "
    "are not") {
  // Along u = 0 the slopes are equal where v = 1/2.
  const CellBox box{{0, 0.49, 0, 0.49}, {0.02, 0.51, 0.02, 0.51}};
  for (const bool apart : {true, false}) {
    const NetPair nets({"u", "v", "v^2"}, {apart ? "-u" : "u", "v", "v^2 + u*(v - 1/2)"});
    ContactCurves curves(nets.first, nets.second, nets.exact_first, nets.exact_second);
    CHECK_FALSE(curves.explains(box));
    CHECK_FALSE(curves.find_along(0, -1, 0, 1));
    CHECK(curves.can_explain());
    CHECK(curves.curves().empty());
    CHECK(curves.explains(box) == apart);
  }
}
