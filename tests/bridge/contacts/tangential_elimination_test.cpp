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
