// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include <eliminant/bridge/roots/fibre_isolation.hpp>
#include <support/curves.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using symbolic::Rational;

namespace {

const Context context;

symbolic::HiddenVariablePolynomial over_x(std::string_view text) {
  return symbolic::hide_variable(test::curve(text), 0);
}

RealBall ball(long value) { return RealBall(Rational(value), 64); }

Rational power_of_two(long exponent) {
  Rational value(1);
  for (; exponent < 0; ++exponent) value = value / Rational(2);
  return value;
}

FibreIsolation isolate(std::string_view g, long exponent, const std::vector<MultipleFibrePoint>& multiple,
                       long degree_drop = 0) {
  const Rational reach = power_of_two(exponent);
  return isolate_fibre(over_x(g), -reach, reach, multiple, degree_drop, 128, context);
}

}  // namespace

TEST_CASE("Fibre isolation: simple roots have one interval each over all of X") {
  const FibreIsolation fibre = isolate("(y - 1)*(y - x)*(y + 2)", -4, {});
  REQUIRE(fibre.state == FibreIsolation::State::isolated);
  REQUIRE(fibre.intervals.size() == 3);
  const std::array<long, 3> roots{-2, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(!fibre.intervals[i].multiple);
    CHECK(fibre.intervals[i].lower < Rational(roots[i]));
    CHECK(Rational(roots[i]) < fibre.intervals[i].upper);
    if (i > 0) CHECK(!(fibre.intervals[i].lower < fibre.intervals[i - 1].upper));
  }
  CHECK(Rational(2) < fibre.bound);
}

TEST_CASE("Fibre isolation: a multiple root is alone in its interval") {
  // A node at the origin, a line beside it.
  const FibreIsolation fibre = isolate("(y^2 - x^2)*(y - 1)", -8, {{ball(0), 2}});
  REQUIRE(fibre.state == FibreIsolation::State::isolated);
  REQUIRE(fibre.intervals.size() == 2);
  CHECK(fibre.intervals[0].multiple == 0);
  CHECK(fibre.intervals[0].upper < Rational(1));
  CHECK(!fibre.intervals[1].multiple);
  // A cusp needs X narrower than its interval.
  CHECK(isolate("y^2 - x^3", 0, {{ball(0), 2}}).state != FibreIsolation::State::isolated);
  CHECK(isolate("y^2 - x^3", -10, {{ball(0), 2}}).state == FibreIsolation::State::isolated);
}

TEST_CASE("Fibre isolation: a wrong multiplicity or an unknown multiple root is never accepted") {
  for (long exponent = -4; exponent > -80; exponent -= 8) {
    // The third derivative has no zero, but of the second there is one.
    CHECK(isolate("y^3 - x", exponent, {{ball(0), 2}}).state != FibreIsolation::State::isolated);
    CHECK(isolate("(y^2 - x^2)*(y - 1)", exponent, {}).state != FibreIsolation::State::isolated);
    CHECK(isolate("x*y - 1", exponent, {}).state != FibreIsolation::State::isolated);
  }
}

TEST_CASE("Fibre isolation: wide enclosures of multiple points are reported") {
  MultipleFibrePoint point{ball(0), 2};
  mag_set_d(arb_radref(point.y.get()), 0.5);
  CHECK(isolate("(y^2 - x^2)*(y - 1)", -40, {point}).state != FibreIsolation::State::isolated);
  CHECK(isolate("(y^2 - x^2)*((y - 1)^2 - x^2)", -40, {point, {ball(1), 2}}).state ==
        FibreIsolation::State::wide_points);
}

TEST_CASE("Fibre isolation: arcs along an asymptote are beyond the bound") {
  const FibreIsolation fibre = isolate("x^2*y - 1", -20, {}, 1);
  REQUIRE(fibre.state == FibreIsolation::State::isolated);
  CHECK(fibre.intervals.empty());
  RationalFibre beside(over_x("x^2*y - 1"), power_of_two(-20), context);
  REQUIRE(beside.count() == 1);
  CHECK(beside.position(0, fibre.bound) == 1);
}

TEST_CASE("Fibre isolation: simple roots are refined to the precision") {
  const auto g = over_x("y^2 - x - 2");
  const Rational reach = power_of_two(-10);
  const FibreIsolation fibre = isolate_fibre(g, -reach, reach, {}, 0, 128, context);
  REQUIRE(fibre.intervals.size() == 2);
  RealBall zero;
  const RealBall root = refine_simple_root(g, zero, fibre.intervals[1], 200);
  CHECK(arb_rel_accuracy_bits(root.get()) > 180);
  RealBall square;
  arb_mul(square.get(), root.get(), root.get(), 200);
  CHECK(arb_contains_si(square.get(), 2) != 0);
  CHECK(arb_is_positive(root.get()) != 0);
}

TEST_CASE("Rational fibre: places of roots are exact") {
  RationalFibre fibre(over_x("(y - 1/3)*(y^2 - 2)*(y^2 + x)"), Rational(0), context);
  // At x = 0 the factor y^2 is a root counted once.
  REQUIRE(fibre.count() == 4);
  const Rational third = Rational(1) / Rational(3);
  CHECK(fibre.position(0, third) == -1);
  CHECK(fibre.position(1, Rational(0)) == 0);
  CHECK(fibre.position(2, third) == 0);
  CHECK(fibre.position(3, third) == 1);
  CHECK(fibre.position(3, Rational(1414213562) / Rational(1000000000)) == 1);
  CHECK(fibre.position(3, Rational(1414213563) / Rational(1000000000)) == -1);
  CHECK(fibre.count_below(Rational(1)) == 3);
  CHECK(fibre.count_below(Rational(-2)) == 0);
  CHECK(arb_rel_accuracy_bits(fibre.refined(3, 300).get()) >= 300);
}
