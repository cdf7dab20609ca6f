// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/local_tables.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::bridge::local;
using namespace eliminant::test;

namespace {

bool holds(const DoubleInterval& interval, double value) { return interval.lower <= value && value <= interval.upper; }

/// A table with 2 + 3 x - x y^2 as first coordinate and the weight 1.
Table table() {
  Table result(2, 3);
  result.at(0, 0) = {2, 0, 0, 1};
  result.at(1, 0)[0] = 3;
  result.at(1, 2)[0] = -1;
  return result;
}

}  // namespace

TEST_CASE("Local tables: moved to a point and to a box") {
  const Table there = moved(table(), {DoubleInterval(2), DoubleInterval(-3)}, 2);
  // Value, derivatives and halves of second derivatives at (2, -3).
  CHECK(holds(there.at(0, 0)[0], 2 + 6 - 18));
  CHECK(holds(there.at(1, 0)[0], 3 - 9));
  CHECK(holds(there.at(0, 1)[0], 12));
  CHECK(holds(there.at(1, 1)[0], 6));
  CHECK(holds(there.at(0, 2)[0], -2));
  CHECK(there.at(0, 0)[0].upper - there.at(0, 0)[0].lower < 1e-12);
  const Table around = moved(table(), {DoubleInterval(-1, 1), DoubleInterval(-2, 2)}, 2);
  for (const double x : {-1.0, 0.3, 1.0})
    for (const double y : {-2.0, 0.0, 1.5}) {
      CHECK(holds(around.at(0, 0)[0], 2 + 3 * x - x * y * y));
      CHECK(holds(around.at(1, 0)[0], 3 - y * y));
      CHECK(holds(around.at(0, 1)[0], -2 * x * y));
    }
  // A square is not negative.
  CHECK(around.at(1, 0)[0].upper < 3 + 1e-12);
}

TEST_CASE("Local tables: sheared along a parabola, and with exchanged parameters") {
  // y = z + x + 2 x^2: x y^2 is x z^2 + 2 x^2 z + ... up to the third order.
  const Table result = sheared(table(), {DoubleInterval(0), DoubleInterval(1), DoubleInterval(2), DoubleInterval(0)});
  CHECK(holds(result.at(0, 0)[0], 2));
  CHECK(holds(result.at(1, 0)[0], 3));
  CHECK(holds(result.at(1, 2)[0], -1));
  CHECK(holds(result.at(2, 1)[0], -2));
  CHECK(holds(result.at(3, 0)[0], -1));
  const Table other = exchanged_parameters(table());
  CHECK(holds(other.at(0, 1)[0], 3));
  CHECK(holds(other.at(2, 1)[0], -1));
}

TEST_CASE("Local tables: in the exact frame nothing but zero is left of slopes along the normal") {
  const bridge::ExactNet exact = patch_net({"u/3 + v^2", "v - u/7", "u*v + u^2/3 - v^3/5", "1 + u/9 + v/11"});
  const bridge::ControlNet net = in_doubles(exact);
  const auto series = taylor_at(exact, {ratio(1, 3), ratio(2, 7)}, 5);
  const auto near = tangent_frame(PatchJets(net).at(1.0 / 3, 2.0 / 7));
  REQUIRE(near);
  const auto frame = exact_frame(series, *near);
  REQUIRE(frame);
  const Table local = enclosed_in(*frame, series, false);
  for (std::size_t k = 0; k < 3; ++k) CHECK(local.at(0, 0)[k].magnitude() == 0);
  CHECK(local.at(1, 0)[2].magnitude() == 0);
  CHECK(local.at(0, 1)[2].magnitude() == 0);
  const EnclosedSlopes slopes(local);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(std::fabs(middle(slopes.slope[i][k]) - (i == k ? 1 : 0)) < 1e-14);
      CHECK(std::fabs(middle(slopes.inverse()[i][k]) - (i == k ? 1 : 0)) < 1e-14);
    }
  // Values elsewhere are those of the patch.
  const Jet jet = jet_at(local, 0.1, -0.05);
  const PatchJets::Value value = PatchJets(net).at(1.0 / 3 + 0.1, 2.0 / 7 - 0.05);
  for (long r = 0; r < 3; ++r) {
    double expected = 0;
    for (std::size_t k = 0; k < 3; ++k)
      expected += near->columns[k][r] * (value.point[static_cast<long>(k)] - near->origin[static_cast<long>(k)]);
    CHECK(jet.value[r] == doctest::Approx(expected));
  }
}
