// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/text_patches.hpp>

#include <eliminant/bridge/nets/taylor_tables.hpp>
#include <eliminant/bridge/nets/zoomed_patches.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

ExactPoint point_at(const ExactNet& net, const Rational& u, const Rational& v) {
  return taylor_at(net, {u, v}, 0).at(0, 0);
}

const PatchText rational_patch{"u^3 - u*v", "v^2 + u/3", "u^2*v - 1/7", "1 + u^2 + v/2"};

}  // namespace

TEST_CASE("Zoomed patches: the part of a patch, exactly, also beyond the domain") {
  const ExactNet net = patch_net(rational_patch);
  for (const auto& [u, v, width] : {std::array{Rational(0), Rational(0), Rational(1)},
                                    {Rational(1) / Rational(3), Rational(2) / Rational(7), Rational(1) / Rational(64)},
                                    {Rational(-1), Rational(3) / Rational(4), Rational(2)}}) {
    const ExactNet part = restricted(net, {u, v}, width);
    for (const auto& [p, q] : {std::array{Rational(0), Rational(1)},
                               {Rational(1) / Rational(5), Rational(3) / Rational(4)},
                               {Rational(1), Rational(1) / Rational(2)}})
      CHECK(point_at(part, p, q) == point_at(net, u + width * p, v + width * q));
  }
  CHECK(restricted(net, {Rational(0), Rational(0)}, Rational(1)).points == net.points);
}

TEST_CASE("Zoomed patches: errors fall with the size, and the way back leads to the same points") {
  const NetPair nets(rational_patch, {"u", "v", "u*v - 1/9"});
  const std::array<Rational, 3> origin{Rational(0), Rational(0), Rational(0)};
  const Rational third = Rational(1) / Rational(3);
  const Rational half = Rational(1) / Rational(2);
  for (const double size : {0x1p-3, 0x1p-10, 0x1p-20}) {
    CAPTURE(size);
    const auto zoomed = ZoomedPatches::around({nets.first, nets.second, nets.exact_first, nets.exact_second, origin},
                                              {third, half, half, third}, size);
    REQUIRE(zoomed);
    const PatchPairNets local = zoomed->nets();
    CHECK(local.first.error.head<3>().maxCoeff() < 0x1p-50 * size);
    const std::array<double, 4> inside{1.0 / 3 + 0.375 * size, 0.5 - 0.25 * size, 0.5, 1.0 / 3 - size};
    const std::array<double, 4> at = zoomed->zoomed(inside);
    CHECK(at[0] == doctest::Approx(0.6875).epsilon(1e-9));
    CHECK(at[1] == doctest::Approx(0.375).epsilon(1e-9));
    CHECK(at[2] == 0.5);
    TracedPoint point;
    point.parameters = at;
    const ExactPoint there = point_at(local.exact_first, exactly(at[0]), exactly(at[1]));
    for (std::size_t k = 0; k < 3; ++k) point.point[k] = nearest(there[k] / there[3] - local.origin[k]);
    const TracedPoint back = zoomed->original(point);
    const ExactPoint expected = point_at(nets.exact_first, exactly(inside[0]), exactly(inside[1]));
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::fabs(back.parameters[k] - inside[k]) < 1e-16);
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::fabs(back.point[k] - nearest(expected[k] / expected[3])) < 1e-15);
  }
}
