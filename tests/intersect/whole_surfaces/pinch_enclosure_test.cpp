// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <eliminant/intersect/whole_surfaces/pinch_arc.hpp>
#include <eliminant/intersect/whole_surfaces/pinch_enclosure.hpp>
#include <support/bezoutian_data.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using Coordinates = std::vector<std::string>;

namespace {

/// With a pinch point at (1/3, 1/5), a double curve u = 1/3.
symbolic::RationalSurface umbrella() {
  return test::weight_first(Coordinates{"1 + u^2", "(u - 1/3)*(v - 1/5)", "(v - 1/5)^2*(1 + u)", "u*(1 + u^2)"},
                            test::first_parameters());
}

}  // namespace

TEST_CASE("Pinch points: enclosed in rectangles that hold one, in every chart") {
  for (const bool inverted : {false, true})
    for (const double reach : {1e-3, 1e-2, 0.03}) {
      CAPTURE(inverted);
      CAPTURE(reach);
      const double u = inverted ? 3.0 : 1.0 / 3;
      const auto found = enclose_pinch_point(umbrella(), {inverted, false},
                                             {{{u - reach, u + 0.7 * reach}, {0.2 - reach, 0.2 + reach}}});
      REQUIRE(found);
      CHECK((*found)[0].lower <= u);
      CHECK((*found)[0].upper >= u);
      CHECK((*found)[1].lower <= 0.2);
      CHECK((*found)[1].upper >= 0.2);
      for (const DoubleInterval& side : *found) CHECK(width(side) < 1e-14);
    }
}

TEST_CASE("Pinch points: a parameter may be known exactly") {
  const auto surface = test::weight_first(Coordinates{"1", "u*v", "v^2", "u"}, test::first_parameters());
  const auto found = enclose_pinch_point(surface, {false, false}, {{{0, 0}, {-1e-3, 2e-3}}});
  REQUIRE(found);
  for (const DoubleInterval& side : *found) CHECK(side.magnitude() < 1e-14);
}

TEST_CASE("Pinch points: none where the surface has two tangents") {
  CHECK_FALSE(enclose_pinch_point(umbrella(), {false, false}, {{{0.34, 0.35}, {0.19, 0.21}}}));
  CHECK_FALSE(enclose_pinch_point(umbrella(), {false, false}, {{{0.3, 0.35}, {0.25, 0.26}}}));
}

TEST_CASE("Pinch points: the double curve leads there") {
  // Phi(1/3, 1/5 + k) = Phi(1/3, 1/5 - k).
  const PointEnclosure from{{}, {1.0 / 3, 0.21, 1.0 / 3, 0.19}};
  const auto at = enclose_pinch_point(umbrella(), {false, false}, {{{0.32, 0.34}, {0.19, 0.21}}});
  REQUIRE(at);
  const auto arc = trace_pinch_arc(umbrella(), from, {false, false}, *at, 1e-9, Context());
  REQUIRE(arc);
  CHECK(arc->error < 2e-9);
  double before = 0.01;
  for (const PointEnclosure& point : arc->points) {
    const double k = middle(point.box[1]) - 0.2;
    CHECK(k <= before);
    before = k;
    CHECK(std::fabs(middle(point.box[3]) - 0.2 + k) < 1e-9);
    CHECK(std::fabs(middle(point.box[0]) - 1.0 / 3) < 1e-9);
    CHECK(std::fabs(middle(point.box[2]) - 1.0 / 3) < 1e-9);
  }
  CHECK(before > 0);
}
