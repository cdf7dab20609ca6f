// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <eliminant/bridge/nets/graph_slopes.hpp>

using namespace eliminant::bridge;

TEST_CASE("Graph slopes: a plane in slanted parameters") {
  // (x, y, z) = (u + v, 2 v, 3 x - y / 2), the parameters changed by the inverse of the derivative.
  const std::array<EnclosedPatch::Point, 2> derivatives{{{1, 0, 3}, {1, 2, 2}}};
  const GraphSlopes graph(derivatives, {{{1, -0.5}, {0, 0.5}}});
  CHECK(graph.contraction < 1e-14);
  const auto is = [](const DoubleInterval& x, double value) {
    return x.lower <= value && value <= x.upper && x.upper - x.lower < 1e-13;
  };
  CHECK(is(graph.normal[0], -3));
  CHECK(is(graph.normal[1], 0.5));
  CHECK(is(graph.normal[2], 1));
  CHECK(is(graph.slope[0][2], 3));
  CHECK(is(graph.slope[1][2], -0.5));
}

TEST_CASE("Graph slopes: nothing is said of a part that may be no graph") {
  const std::array<EnclosedPatch::Point, 2> derivatives{{{DoubleInterval(-1, 1), 0, 1}, {0, 1, 1}}};
  const GraphSlopes graph(derivatives, {{{1, 0}, {0, 1}}});
  CHECK(graph.contraction > 1);
  CHECK_FALSE(std::isfinite(graph.normal[0].magnitude()));
}
