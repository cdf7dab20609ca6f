// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/text_patches.hpp>

#include <eliminant/bridge/nets/ball_patch.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

RealBall ball(const symbolic::Rational& value) { return {value, 128}; }

bool encloses(const RealBall& found, const symbolic::Rational& value) {
  return arb_contains_fmpq(found.get(), value.get()) != 0 && mag_get_d(arb_radref(found.get())) < 1e-35;
}

}  // namespace

TEST_CASE("Ball patch: encloses the exact point, of polynomial and rational patches, beyond the domain, too") {
  const PatchText text{"u^2 - v/3", "u*v^3", "1 - u + v", "1 + u*v/2"};
  for (const bool rational : {false, true}) {
    const PatchText patch = rational ? text : PatchText{text.x, text.y, text.z};
    const BallPatch balls(patch_net(patch), 128);
    for (const auto& [u, v] : {std::pair{ratio(1, 3), ratio(2, 7)}, std::pair{ratio(-1, 5), ratio(6, 5)}}) {
      const symbolic::Rational w =
          rational ? symbolic::Rational(1) + u * v / symbolic::Rational(2) : symbolic::Rational(1);
      const auto point = balls.point_at(ball(u), ball(v));
      CHECK(encloses(point[0], (u * u - v / symbolic::Rational(3)) / w));
      CHECK(encloses(point[1], u * v * v * v / w));
      CHECK(encloses(point[2], (symbolic::Rational(1) - u + v) / w));
    }
  }
}

TEST_CASE("Ball patch: derivatives by both parameters are those of the quotients") {
  const BallPatch balls(patch_net({"u*v^2", "v", "u", "1 + u"}), 128);
  const symbolic::Rational u = ratio(1, 3);
  const symbolic::Rational v = ratio(2, 5);
  const auto jet = balls.jet_at(ball(u), ball(v));
  const symbolic::Rational w = symbolic::Rational(1) + u;
  CHECK(encloses(jet.point[0], u * v * v / w));
  CHECK(encloses(jet.by[0][0], v * v / (w * w)));
  CHECK(encloses(jet.by[1][0], symbolic::Rational(2) * u * v / w));
  CHECK(encloses(jet.by[0][1], symbolic::Rational(0) - v / (w * w)));
  CHECK(encloses(jet.by[1][2], symbolic::Rational(0)));
}

TEST_CASE("Ball patch: where the weight is zero no coordinate is finite") {
  const BallPatch balls(patch_net({"1", "v", "u", "u - 1/2"}), 64);
  CHECK(arb_is_finite(balls.point_at(ball(ratio(1, 2)), ball(ratio(1, 3)))[0].get()) == 0);
}
