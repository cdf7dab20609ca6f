// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/text_patches.hpp>

#include <eliminant/bridge/nets/parameter_change.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using eliminant::test::patch_net;
using symbolic::Integer;
using symbolic::Rational;

namespace {

using test::ratio;

// Biquadratic, without any symmetry.
const test::PatchText bent{"u + u*v^2/8", "v - u^2/5 + u*v/7", "u^2 + 3*u*v - v^2*u^2 + v/3"};
const test::PatchText rational{"u + u*v", "v - u^2*v", "u^2 - v", "2 + u + u*v^2"};

ExactNet exchanged(const ExactNet& net) {
  ExactNet result{{net.degrees[1], net.degrees[0]}, net.points};
  for (std::size_t i = 0; i <= net.degrees[0]; ++i)
    for (std::size_t j = 0; j <= net.degrees[1]; ++j)
      result.points[j * (net.degrees[0] + 1) + i] = net.points[i * (net.degrees[1] + 1) + j];
  return result;
}

}  // namespace

TEST_CASE("Projective maps: through three pairs, with inverses and poles") {
  const auto map =
      ProjectiveMap::through({Rational(0), Rational(1), ratio(1, 2)}, {Rational(2), Rational(4), Rational(3)});
  REQUIRE(map);
  CHECK(*map->at(ratio(1, 4)) == ratio(5, 2));
  const auto curved =
      ProjectiveMap::through({Rational(0), Rational(1), Rational(2)}, {Rational(0), Rational(1), Rational(4)});
  REQUIRE(curved);
  CHECK(*curved->at(Rational(2)) == Rational(4));
  // x -> 2 x / (3 - x).
  CHECK(*curved->at(Rational(-1)) == ratio(-1, 2));
  CHECK_FALSE(curved->at(Rational(3)));
  CHECK(*curved->inverse().at(Rational(4)) == Rational(2));
  CHECK_FALSE(ProjectiveMap::through({Rational(0), Rational(0), Rational(2)}, {Rational(0), Rational(1), Rational(4)}));
  CHECK_FALSE(ProjectiveMap::through({Rational(0), Rational(1), Rational(2)}, {Rational(0), Rational(1), Rational(1)}));
}

TEST_CASE("Composed nets: an affine change is the net on another interval") {
  for (const test::PatchText& text : {bent, rational}) {
    const test::Sides sides{symbolic::Interval{ratio(1, 3), ratio(3, 4)}, symbolic::Interval{-1, 2}};
    ExactNet part = patch_net(text);
    for (std::size_t axis = 0; axis < 2; ++axis)
      part = composed(part, axis, {sides[axis].upper - sides[axis].lower, sides[axis].lower, 0, 1});
    const ExactNet expected = patch_net(text, sides);
    REQUIRE(part.points.size() == expected.points.size());
    for (std::size_t i = 0; i < part.points.size(); ++i) CHECK(part.points[i] == expected.points[i]);
  }
}

TEST_CASE("Parameter changes: recognised exactly, affine and projective, with the parameters exchanged") {
  // Second patch at maps(u, v) is the first: the second is the first after the inverse maps.
  const std::vector<std::array<ProjectiveMap, 2>> changes{
      {ProjectiveMap{1, 0, 0, 1}, ProjectiveMap{1, 0, 0, 1}},
      {ProjectiveMap{-1, 1, 0, 1}, ProjectiveMap{1, 0, 0, 1}},
      {ProjectiveMap{3, -1, 0, 2}, ProjectiveMap{2, ratio(1, 7), 0, 3}},
      {ProjectiveMap{3, 1, 1, 4}, ProjectiveMap{-7, 5, 2, 6}},
  };
  for (const test::PatchText& text : {bent, rational})
    for (const auto& maps : changes)
      for (const bool exchange : {false, true}) {
        const ExactNet first = patch_net(text);
        ExactNet second = first;
        for (std::size_t axis = 0; axis < 2; ++axis) second = composed(second, axis, maps[axis].inverse());
        if (exchange) second = exchanged(second);
        std::array<double, 2> image{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
          const Rational there = *maps[axis].at(ratio(1, 2));
          image[exchange ? 1 - axis : axis] = fmpq_get_d(there.get());
        }
        const auto found = parameter_change(first, second, {0.5, 0.5, image[0] + 1e-9, image[1] - 1e-9});
        REQUIRE(found);
        CHECK(found->exchanged == exchange);
        for (std::size_t axis = 0; axis < 2; ++axis)
          for (const long x : {0L, 1L, 5L}) {
            const auto expected = maps[axis].at(Rational(x));
            const auto value = found->maps[axis].at(Rational(x));
            REQUIRE(expected.has_value() == value.has_value());
            if (expected) CHECK(*expected == *value);
          }
        CHECK(is_same_map(first, second, *found));
      }
}

TEST_CASE("Parameter changes: none between different maps, of other degrees, or from no common point") {
  const ExactNet first = patch_net(bent);
  ExactNet other = first;
  // One control point moved by 2^-80.
  Rational little;
  fmpz_one(fmpq_numref(little.get()));
  fmpz_one_2exp(fmpq_denref(little.get()), 80);
  other.points[4][2] = other.points[4][2] + little;
  CHECK_FALSE(parameter_change(first, other, {0.5, 0.5, 0.5, 0.5}));
  CHECK_FALSE(is_same_map(first, other, ParameterChange()));
  CHECK_FALSE(parameter_change(first, patch_net({"u", "v", "u*v"}), {0.5, 0.5, 0.5, 0.5}));
  const ExactNet above = patch_net({bent.x, bent.y, bent.z + " + 1/1000"});
  CHECK_FALSE(parameter_change(first, above, {0.5, 0.5, 0.5, 0.5}));
  // One surface, but not by changes of each parameter alone.
  CHECK_FALSE(parameter_change(patch_net({"u", "v", "0"}), patch_net({"u + v", "u - v", "0"}), {0.5, 0.5, 0.5, 0}));
}
