// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/bezier_nets.hpp>

#include <eliminant/bridge/branches/bezier_common_points.hpp>
#include <eliminant/bridge/contacts/exact_contact.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

/// A pair and its prover.
struct Pair {
  ExactNet exact_first;
  ExactNet exact_second;
  ControlNet first;
  ControlNet second;
  ContactProver prover;

  Pair(ExactNet a, ExactNet b)
      : exact_first(std::move(a)),
        exact_second(std::move(b)),
        first(in_doubles(exact_first)),
        second(in_doubles(exact_second)),
        prover(
            first, second, [this]() -> const ExactNet& { return exact_first; },
            [this]() -> const ExactNet& { return exact_second; }) {}
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

  std::optional<std::vector<BezierCommonPoint>> all() const {
    const Context context;
    return bezier_common_points(
        first, second, [this]() -> const ExactNet& { return exact_first; },
        [this]() -> const ExactNet& { return exact_second; }, context);
  }
};

/// y = p(x) against y = p(x) + difference(x).
Pair graphs(const Powers& difference) {
  const Powers p = powers({1, -2, 1, 1});
  return Pair(curve_net({t, p + difference, zero, one}), curve_net({t, p, zero, one}));
}

/// A curve over the diagonal of a saddle, above it by the difference.
Pair above_saddle(const Powers& difference) {
  return Pair(curve_net({t, t, on_saddle(3, -1, t, t) + difference, one}), saddle_net(3, -1));
}

bool contains(const OpenBox& box, std::size_t k, double value) { return box.lower[k] < value && value < box.upper[k]; }

}  // namespace

TEST_CASE("Exact contact: orders 2 to 5 at rational parameters, in the plane and on a patch") {
  const std::vector<std::pair<long, long>> fractions{{1, 2}, {1, 3}, {3, 7}, {5, 16}};
  for (const std::pair<long, long>& fraction : fractions)
    for (unsigned order = 2; order <= 5; ++order) {
      const long p = fraction.first;
      const long q = fraction.second;
      CAPTURE(p);
      CAPTURE(q);
      CAPTURE(order);
      const double at = static_cast<double>(p) / static_cast<double>(q);
      Pair plane = graphs(root(p, q, order));
      const auto box = plane.prover.find({at + 0.01, at - 0.01, 0}, 0.2);
      REQUIRE(box.has_value());
      CHECK(contains(*box, 0, at));
      CHECK(contains(*box, 1, at));
      REQUIRE(plane.prover.contacts().size() == 1);
      CHECK(plane.prover.contacts()[0].multiplicity == order);
      CHECK(plane.prover.contacts()[0].parameters[0] == ratio(p, q));
      CHECK(plane.prover.contacts()[0].parameters[1] == ratio(p, q));
      // Known already.
      CHECK_FALSE(plane.prover.find({at, at, 0}, 0.1).has_value());
      CHECK(plane.prover.contacts().size() == 1);

      Pair patch = above_saddle(root(p, q, order));
      REQUIRE(patch.prover.find({at - 0.01, at, at + 0.01}, 0.2).has_value());
      CHECK(patch.prover.contacts()[0].multiplicity == order);
      for (std::size_t k = 0; k < 3; ++k) CHECK(patch.prover.contacts()[0].parameters[k] == ratio(p, q));
    }
}

TEST_CASE("Exact contact: a projective map keeps the order") {
  const std::array<std::array<long, 4>, 4> projective{{{3, 1, 0, 1}, {-1, 2, 1, 0}, {0, 1, 4, 2}, {1, 1, 0, 4}}};
  for (unsigned order = 2; order <= 4; ++order) {
    CAPTURE(order);
    const Pair plain = above_saddle(root(1, 3, order) * root(3, 4));
    ExactNet curve = plain.exact_first;
    ExactNet patch = plain.exact_second;
    transform(curve, projective);
    transform(patch, projective);
    const auto points = Pair(curve, patch).all();
    REQUIRE(points.has_value());
    REQUIRE(points->size() == 2);
    unsigned long total = 0;
    for (const BezierCommonPoint& point : *points) total += point.multiplicity;
    CHECK(total == order + 1);
  }
}

TEST_CASE("Exact contact: none is claimed where there is none") {
  // A gap, a crossing pair, irrational parameters, a sixth order.
  CHECK_FALSE(graphs(root(1, 3, 2) + Powers{ratio(1, 1L << 40)}).prover.find({0.33, 0.33, 0}, 0.1).has_value());
  CHECK_FALSE(graphs(root(1, 3, 2) + Powers{ratio(-1, 1L << 40)}).prover.find({0.33, 0.33, 0}, 0.1).has_value());
  CHECK_FALSE(graphs(root(1, 3)).prover.find({0.33, 0.33, 0}, 0.1).has_value());
  const Powers irrational = powers({-1, 0, 2});
  CHECK_FALSE(graphs(irrational * irrational).prover.find({0.7, 0.7, 0}, 0.1).has_value());
  CHECK_FALSE(graphs(root(1, 3, 6)).prover.find({0.33, 0.33, 0}, 0.1).has_value());
  // One curve twice.
  CHECK_FALSE(graphs(zero).prover.find({0.5, 0.5, 0}, 0.1).has_value());
}

TEST_CASE("Exact contact: its box keeps out of zeros and contacts beside it") {
  for (const long q : {2L, 8L, 64L, 1024L}) {
    CAPTURE(q);
    const double beside = 0.5 + 1 / static_cast<double>(q);
    Pair crossed = graphs(root(1, 2, 2) * root(q + 2, 2 * q));
    const auto box = crossed.prover.find({0.5, 0.5, 0}, 0.2 / static_cast<double>(q));
    // A box may be too narrow to be proven.
    if (q <= 64) REQUIRE(box.has_value());
    if (box) CHECK_FALSE(contains(*box, 0, beside));
    const auto points = crossed.all();
    if (points) {
      unsigned long total = 0;
      for (const BezierCommonPoint& point : *points) total += point.multiplicity;
      CHECK(points->size() == 2);
      CHECK(total == 3);
    }
    const auto twice = graphs(root(1, 2, 2) * root(q + 2, 2 * q, 2)).all();
    if (twice) {
      REQUIRE(twice->size() == 2);
      for (const BezierCommonPoint& point : *twice) CHECK(point.multiplicity == 2);
    }
  }
}

TEST_CASE("Exact contact: a singular point of the second side is none, also where doubles do not see it") {
  // Cusps at 1/3, and a line along the cusp's tangent.
  const ExactNet cusp = curve_net({root(1, 3, 2), root(1, 3, 3), zero, one});
  Pair along(curve_net({powers({-1, 2}), zero, zero, one}), cusp);
  CHECK_FALSE(along.prover.find({0.5, 1.0 / 3, 0}, 0.1).has_value());
  CHECK_FALSE(along.all().has_value());
  // Two cusps in one point, at rounded control points.
  Pair both(ExactNet{{3}, {{15, 9, 0, 3}, {7, 3, 0, 3}, {6, 3, 0, 3}, {6, 3, 0, 3}}},
            ExactNet{{3}, {{12, 6, 0, 3}, {7, 3, 0, 3}, {6, 3, 0, 3}, {6, 3, 0, 3}}});
  CHECK_FALSE(both.all().has_value());
  for (double at = 0.97; at < 1.02; at += 0.01) CHECK_NOTHROW(both.prover.find({at, at, 0}, 0.25));
  // The first may be singular: the cusp of (t^2, t^3) has order 2 with lines across it, 3 with its tangent.
  Pair across(cusp, curve_net({powers({-1, 2}), powers({-1, 2}), zero, one}));
  REQUIRE(across.prover.find({1.0 / 3 + 0.01, 0.5, 0}, 0.2).has_value());
  CHECK(across.prover.contacts()[0].multiplicity == 2);
  Pair tangent(cusp, curve_net({powers({-1, 2}), zero, zero, one}));
  REQUIRE(tangent.prover.find({1.0 / 3 + 0.01, 0.5, 0}, 0.2).has_value());
  CHECK(tangent.prover.contacts()[0].multiplicity == 3);
}

TEST_CASE("Exact contact: the parameters of simple zeros are recognised where they are simple fractions") {
  Pair pair = graphs(root(2, 7) * powers({-1, 0, 2}));
  const Context context;
  const SubdivisionResult found = bernstein_subdivision(pair.first, pair.second, {}, SubdivisionLimits(), context);
  REQUIRE(found.zeros.size() == 2);
  unsigned rational = 0;
  for (const IsolatedZero& zero : found.zeros) {
    const auto exact = pair.prover.exact_zero(zero);
    if (!exact) continue;
    ++rational;
    CHECK((*exact)[0] == ratio(2, 7));
    CHECK((*exact)[1] == ratio(2, 7));
  }
  CHECK(rational == 1);
  // A zero of this radius is not known well enough.
  CHECK_FALSE(pair.prover.exact_zero({{2.0 / 7, 2.0 / 7, 0}, 1e-8, 1e-3}).has_value());
}

TEST_CASE("Exact contact: rounded parameters are exact where they can be") {
  CHECK(rounded_parameters({ratio(3, 8), Rational(0), Rational(1)}).radius == 0);
  CHECK(rounded_parameters({ratio(3, 8), Rational(0), Rational(1)}).parameters == std::array<double, 3>{0.375, 0, 1});
  const IsolatedZero third = rounded_parameters({ratio(1, 3), ratio(2, 3), Rational(0)});
  CHECK(third.radius > 0);
  CHECK(third.radius < 1e-15);
}

TEST_CASE("Double interval: infinite ends never exclude zero") {
  const DoubleInterval all{-INFINITY, INFINITY};
  CHECK_FALSE((DoubleInterval(-1, 0) * DoubleInterval(-INFINITY, -2)).excludes_zero());
  CHECK_FALSE((DoubleInterval(0) * all).excludes_zero());
  CHECK_FALSE((DoubleInterval(1) / DoubleInterval(-1, 1)).excludes_zero());
  CHECK_FALSE(DoubleInterval(NAN, -1).excludes_zero());
  CHECK((DoubleInterval(1, 2) * DoubleInterval(-3, -2)).upper < 0);
}
