// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/tangential_elimination.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

CellBox box_around(double u, double v, double half) {
  return {{u - half, v - half, u - half, v - half}, {u + half, v + half, u + half, v + half}};
}

const std::string wave = "u^2*v - u*v^2 + u/3 + v^3/4";

NetPair raised(const std::string& height) { return {{"u", "v", wave}, {"u", "v", wave + " + " + height}}; }

}  // namespace

TEST_CASE("Tangential elimination: the Hessian of the height of one graph over another") {
  // Along the normal, which is vertical where the plane is.
  const NetPair nets({"u", "v", "0"}, {"u", "v", "(u - 1/2)^2 + 3*(u - 1/2)*(v - 1/2) - 2*(v - 1/2)^2"});
  const auto found =
      TangentialElimination::on(nets.first, nets.second, {0.5, 0.5, 0.5, 0.5}, box_around(0.5, 0.5, 0x1p-10));
  REQUIRE(found);
  const auto holds = [](const DoubleInterval& x, double value) {
    return x.lower <= value && value <= x.upper && x.upper - x.lower < 0.05;
  };
  CHECK(holds(found->hessian.uu, -2));
  CHECK(holds(found->hessian.uv, -3));
  CHECK(holds(found->hessian.vv, 4));
  CHECK(holds(found->hessian.form({1, 1}, {1, -1}), -6));
  CHECK(found->hessian.determinant().upper < 0);
  CHECK(holds(found->gradient[0], 0));
  CHECK(holds(found->gradient[1], 0));
}

TEST_CASE("Tangential elimination: parallel parts keep a distance, on boxes far larger than it") {
  for (const double half : {0.01, 0.03}) {
    CHECK(keep_distance(raised("1/1000").first, raised("1/1000").second, box_around(0.5, 0.375, half)));
    CHECK(keep_distance(raised("-1/1000").first, raised("-1/1000").second, box_around(0.25, 0.625, half)));
  }
  const NetPair close = raised("1/100000");
  CHECK(keep_distance(close.first, close.second, box_around(0.5, 0.375, 0.005)));
  // A bowl above its tangent plane.
  const NetPair bowl({"u", "v", "0"}, {"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 + 1/100000"});
  CHECK(keep_distance(bowl.first, bowl.second, box_around(0.5, 0.5, 0.05)));
}

TEST_CASE("Tangential elimination: no distance is claimed where there are common points") {
  for (const std::string height :
       {"0", "(u - 1/2)^2", "(u - 1/2)*(v - 1/2)", "(u - 1/2)^2 + (v - 1/2)^2", "(u - 1/2)/1000",
        "(u - 1/2)^2 - 1/1000000", "(u - 1/2)^2 + (v - 1/2)^2 - 1/10000000"}) {
    CAPTURE(height);
    const NetPair nets = raised(height);
    for (const double half : {0.1, 0.01, 0.005, 0.002}) {
      CHECK_FALSE(keep_distance(nets.first, nets.second, box_around(0.5, 0.5, half)));
      CHECK_FALSE(keep_distance(nets.first, nets.second, box_around(0.5 + half / 3, 0.5 - half / 4, half)));
    }
  }
}
