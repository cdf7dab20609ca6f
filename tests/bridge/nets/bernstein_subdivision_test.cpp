// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <support/bezier_nets.hpp>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/nets/bernstein_subdivision.hpp>
#include <eliminant/bridge/nets/bezier_part.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

SubdivisionResult subdivide(const ControlNet& first, const ControlNet& second,
                            const SubdivisionLimits& limits = SubdivisionLimits()) {
  const Context context;
  return bernstein_subdivision(first, second, {}, limits, context);
}

SubdivisionResult subdivide(const ExactNet& first, const ExactNet& second) {
  return subdivide(in_doubles(first), in_doubles(second));
}

Rational exactly(double value) {
  RealBall ball;
  arb_set_d(ball.get(), value);
  Rational result;
  arf_get_fmpq(result.get(), arb_midref(ball.get()));
  return result;
}

Rational magnitude(const Rational& x) { return x.sign() < 0 ? -x : x; }

/// Whether these parameters lie in the enclosure of the zero.
bool holds(const IsolatedZero& zero, const std::vector<Rational>& parameters) {
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (exactly(zero.radius) < magnitude(exactly(zero.parameters[k]) - parameters[k])) return false;
  return true;
}

/// Whether the zeros are these, all within narrow enclosures and apart, and nothing is left open.
bool are_these(const SubdivisionResult& found, const std::vector<std::vector<Rational>>& expected) {
  if (!found.complete || !found.open.empty() || found.zeros.size() != expected.size()) return false;
  return std::all_of(expected.begin(), expected.end(), [&](const std::vector<Rational>& parameters) {
    return std::count_if(found.zeros.begin(), found.zeros.end(), [&](const IsolatedZero& zero) {
             return holds(zero, parameters) && zero.radius < 0x1p-26 && zero.isolation > zero.radius;
           }) == 1;
  });
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11U), -53);
  }

 private:
  std::mt19937_64 engine_;
};

std::vector<HomogeneousPoint> random_points(Draw& draw, std::size_t count, bool weighted, bool in_plane) {
  std::vector<HomogeneousPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double w = weighted ? draw.number(0.25, 4) : 1;
    points.push_back({w * draw.number(-1, 1), w * draw.number(-1, 1), in_plane ? 0 : w * draw.number(-1, 1), w});
  }
  return points;
}

}  // namespace

TEST_CASE("Bernstein subdivision: finds planted simple zeros of a curve and a patch, each once") {
  const Powers z = on_saddle(2, 1, t, one + powers({-1}) * t) + root(1, 8) * root(1, 3) * root(7, 8);
  const ExactNet curve = curve_net({t, one + powers({-1}) * t, z, one});
  const ExactNet patch = saddle_net(2, 1);
  CHECK(are_these(subdivide(curve, patch), {{ratio(1, 8), ratio(1, 8), ratio(7, 8)},
                                            {ratio(1, 3), ratio(1, 3), ratio(2, 3)},
                                            {ratio(7, 8), ratio(7, 8), ratio(1, 8)}}));
}

TEST_CASE("Bernstein subdivision: finds planted simple zeros of two plane curves, also close together") {
  const Powers p = powers({1, -3, 2});
  for (const long q : {3L, 1000L, 100000L}) {
    CAPTURE(q);
    const ExactNet first = curve_net({t, p + root(q, 2 * q) * root(q + 1, 2 * q), zero, one});
    const ExactNet second = curve_net({t, p, zero, one});
    CHECK(
        are_these(subdivide(first, second), {{ratio(1, 2), ratio(1, 2)}, {ratio(q + 1, 2 * q), ratio(q + 1, 2 * q)}}));
  }
}

TEST_CASE("Bernstein subdivision: weights on neither, one or both sides give the same zeros") {
  // A projective map keeps the parameters.
  const std::array<std::array<long, 4>, 4> projective{{{3, 1, 0, 1}, {-1, 2, 1, 0}, {0, 1, 4, 2}, {1, 1, 0, 4}}};
  const ExactNet patch = saddle_net(1, 1);
  const ExactNet line = curve_net({powers({1}), powers({1}), powers({-4, 12}), powers({4})});
  // (1/4, 1/4, -1 + 3 t) meets z = 3/16 at t = 19/48.
  const std::vector<std::vector<Rational>> expected{{ratio(19, 48), ratio(1, 4), ratio(1, 4)}};
  CHECK(are_these(subdivide(line, patch), expected));
  ExactNet weighted_line = line;
  ExactNet weighted_patch = patch;
  transform(weighted_line, projective);
  transform(weighted_patch, projective);
  CHECK(are_these(subdivide(weighted_line, weighted_patch), expected));
  // The weights of one side alone: another parametrisation of the same line, t -> t / (2 - t).
  const ExactNet rational_line = curve_net({powers({2, -1}), powers({2, -1}), powers({-8, 16}), powers({8, -4})});
  const std::vector<std::vector<Rational>> moved{{ratio(38, 67), ratio(1, 4), ratio(1, 4)}};
  CHECK(are_these(subdivide(rational_line, patch), moved));
  // And a rational conic against polynomial lines: x^2 + y^2 = 1 at (3/5, 4/5) is u = 1/2.
  const ExactNet circle = curve_net({powers({1, 0, -1}), powers({0, 2}), zero, powers({1, 0, 1})});
  const ExactNet chord = curve_net({powers({0, 6}), powers({0, 8}), zero, powers({5})});
  CHECK(are_these(subdivide(chord, circle), {{ratio(1, 2), ratio(1, 2)}}));
  CHECK(are_these(subdivide(circle, chord), {{ratio(1, 2), ratio(1, 2)}}));
}

TEST_CASE("Bernstein subdivision: encloses zeros on borders and in corners, and leaves out those beyond") {
  const ExactNet patch = saddle_net(1, 1);
  const auto upright = [](const Rational& x, const Rational& y) {
    return curve_net({Powers{x}, Powers{y}, powers({-1, 4}), one});
  };
  CHECK(are_these(subdivide(upright(0, ratio(1, 2)), patch), {{ratio(5, 16), 0, ratio(1, 2)}}));
  CHECK(are_these(subdivide(upright(1, 1), patch), {{1, 1, 1}}));
  CHECK(are_these(subdivide(upright(0, 0), patch), {{ratio(1, 4), 0, 0}}));
  const Rational little = ratio(1, 1L << 30);
  CHECK(are_these(subdivide(upright(-little, ratio(1, 2)), patch), {}));
  CHECK(are_these(subdivide(upright(little, little), patch),
                  {{(Rational(1) + Rational(3) * little * little) / Rational(4), little, little}}));
}

TEST_CASE("Bernstein subdivision: leaves a contact open, and excludes a gap above it") {
  const Powers p = powers({0, 0, 1});
  const ExactNet parabola = curve_net({t, p, zero, one});
  const auto tangent = [&](const Rational& gap) {
    return curve_net({t, p + Powers{-gap} + Powers{ratio(-1, 9)} * root(1, 3, 2), zero, one});
  };
  // y = u^2 - (3 u - 1)^2 / 9 is a line.
  const SubdivisionResult touching = subdivide(tangent(0), parabola);
  REQUIRE(touching.open.size() == 1);
  CHECK(touching.zeros.empty());
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(touching.open[0].lower[k] < 1.0 / 3 + 1e-5);
    CHECK(touching.open[0].upper[k] > 1.0 / 3 - 1e-5);
  }
  CHECK(are_these(subdivide(tangent(ratio(1, 1L << 40)), parabola), {}));
  // (3 u - 1)^2 = 9 / 2^36.
  const Rational third = ratio(1, 3);
  const Rational apart = ratio(1, 1L << 18);
  CHECK(are_these(subdivide(tangent(ratio(-1, 1L << 36)), parabola),
                  {{third - apart, third - apart}, {third + apart, third + apart}}));
}

TEST_CASE("Bernstein subdivision: weights of mixed sign, too many pairs and cancelling end it") {
  const ExactNet line = curve_net({powers({-1, 2}), powers({0, 1}), zero, one});
  const ExactNet mixed = curve_net({powers({1, 1}), powers({0, 1}), zero, powers({1, -3})});
  CHECK_FALSE(subdivide(line, mixed).complete);
  CHECK_FALSE(subdivide(mixed, line).complete);

  // One curve twice: nothing can be excluded along it.
  const ExactNet twice = curve_net({t, powers({0, 1, 1}), zero, one});
  SubdivisionLimits limits;
  limits.most_open = 1000000;
  limits.most_pairs = 5000;
  const SubdivisionResult cut_short = subdivide(in_doubles(twice), in_doubles(twice), limits);
  CHECK_FALSE(cut_short.complete);
  CHECK(cut_short.pairs <= 5001);
  Context context;
  context.cancel();
  CHECK_THROWS_AS(bernstein_subdivision(in_doubles(twice), in_doubles(twice), {}, limits, context), LimitReached);
}

TEST_CASE("Bernstein subdivision: random pairs keep their zeros when reversed, swapped or halved") {
  Draw draw(20);
  unsigned compared = 0;
  unsigned seen = 0;
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    const bool in_plane = round % 2 == 0;
    const std::size_t degree = 1 + static_cast<std::size_t>(round % 5);
    const std::vector<HomogeneousPoint> curve = random_points(draw, degree + 1, round % 3 == 0, in_plane);
    const std::vector<std::size_t> degrees =
        in_plane ? std::vector<std::size_t>{2 + degree % 3} : std::vector<std::size_t>{2, 3};
    const std::vector<HomogeneousPoint> other =
        random_points(draw, in_plane ? degrees[0] + 1 : 12, round % 4 == 1, in_plane);
    const auto net = [](const std::vector<std::size_t>& d, const std::vector<HomogeneousPoint>& points) {
      return ControlNet::of(d, points, {0, 0, 0}).value();
    };
    const SubdivisionResult whole = subdivide(net({degree}, curve), net(degrees, other));
    if (!whole.complete || !whole.open.empty()) continue;
    const auto has = [&](const IsolatedZero& zero, const std::array<double, 3>& at, double radius) {
      for (std::size_t k = 0; k <= degrees.size(); ++k)
        if (std::fabs(zero.parameters[k] - at[k]) > zero.radius + radius + 1e-15) return false;
      return true;
    };
    const auto same = [&](const SubdivisionResult& found, const auto& back) {
      REQUIRE(found.complete);
      REQUIRE(found.zeros.size() == whole.zeros.size());
      for (const IsolatedZero& zero : found.zeros) {
        const std::array<double, 3> at = back(zero.parameters);
        CHECK(std::count_if(whole.zeros.begin(), whole.zeros.end(),
                            [&](const IsolatedZero& z) { return has(z, at, zero.radius); }) == 1);
      }
    };
    const std::vector<HomogeneousPoint> reversed(curve.rbegin(), curve.rend());
    same(subdivide(net({degree}, reversed), net(degrees, other)), [](std::array<double, 3> at) {
      return std::array<double, 3>{1 - at[0], at[1], at[2]};
    });
    if (in_plane)
      same(subdivide(net(degrees, other), net({degree}, curve)), [](std::array<double, 3> at) {
        return std::array<double, 3>{at[1], at[0], 0};
      });
    ++compared;
    seen += static_cast<unsigned>(whole.zeros.size());
  }
  CHECK(compared > 350);
  CHECK(seen > 200);
}

TEST_CASE("Parts of a control net: restricting, cutting and halving err by no more than they say") {
  Draw draw(21);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const auto degree = static_cast<std::size_t>(1 + round % 20);
    const NetShape<1> shape{{degree}};
    std::vector<Array4d> points(degree + 1);
    for (Array4d& point : points)
      for (long k = 0; k < 4; ++k) point[k] = draw.number(-1, 1);
    const double lower = draw.number(-0.02, 0.6);
    const double upper = lower + draw.number(0.01, 0.4);
    std::vector<Array4d> part = points;
    restrict_to(shape, 0, lower, upper, part.data());
    std::vector<Array4d> left = points;
    std::vector<Array4d> right(points.size());
    halve(shape, 0, left.data(), right.data());
    const double place = draw.number(0.02, 0.98);
    std::vector<Array4d> below = points;
    std::vector<Array4d> above(points.size());
    cut_at(shape, 0, place, below.data(), above.data());
    const double size = std::exp(0.04 * static_cast<double>(degree));
    const double bound = 10 * static_cast<double>(degree) * unit_roundoff * size;
    for (long k = 0; k < 4; ++k) {
      std::vector<Rational> exact;
      for (const Array4d& point : points) exact.push_back(exactly(point[k]));
      const std::vector<Rational> power = symbolic::power_coefficients(exact, {0, 1});
      const auto compare = [&](const std::vector<Array4d>& got, const Rational& from, const Rational& to, double most) {
        const std::vector<Rational> expected = symbolic::bernstein_coefficients(power, {from, to});
        for (std::size_t i = 0; i < got.size(); ++i)
          CHECK_FALSE(exactly(most) < magnitude(exactly(got[i][k]) - expected[i]));
      };
      // The place itself is rounded, which moves values by their slope.
      compare(part, exactly(lower), exactly(upper), bound + 8 * unit_roundoff * 2 * static_cast<double>(degree) * size);
      compare(left, 0, ratio(1, 2), static_cast<double>(degree) * unit_roundoff);
      compare(right, ratio(1, 2), 1, static_cast<double>(degree) * unit_roundoff);
      compare(below, 0, exactly(place), 4 * static_cast<double>(degree) * unit_roundoff);
      compare(above, exactly(place), 1, 4 * static_cast<double>(degree) * unit_roundoff);
    }
  }
}

TEST_CASE("Control net: the error holds what moving and rounding lost, and numbers out of range are refused") {
  const auto point = [](const Rational& x) { return ExactPoint{x, Rational(0), Rational(0), Rational(1)}; };
  Rational tiny(1);
  for (int i = 0; i < 400; ++i) tiny = tiny / Rational(10);
  CHECK_FALSE(ControlNet::round({1}, {point(tiny), point(1)}, {}).has_value());
  CHECK_FALSE(ControlNet::round({1}, {point(Rational(1) / tiny), point(1)}, {}).has_value());
  const ControlNet third = ControlNet::round({1}, {point(ratio(1, 3)), point(1)}, {}).value();
  CHECK(third.polynomial);
  CHECK_FALSE(exactly(third.error[0]) < magnitude(exactly(third.points[0][0]) - ratio(1, 3)));
  CHECK(third.error[3] == 0);

  CHECK_FALSE(ControlNet::of({1}, {{1e-70, 0, 0, 1}, {1, 0, 0, 1}}, {0, 0, 0}).has_value());
  CHECK_FALSE(ControlNet::of({1}, {{1e70, 0, 0, 1}, {1, 0, 0, 1}}, {0, 0, 0}).has_value());
  const ControlNet integers = ControlNet::of({1}, {{5, 7, 0, 1}, {-3, 2, 0, 1}}, {5, 7, 0}).value();
  CHECK(integers.error.maxCoeff() == 0);
  CHECK(integers.points[1][0] == -8);
  // Also with weights, as long as the products have few digits.
  const ControlNet weighted = ControlNet::of({1}, {{0x1p30, 7, 0, 3}, {-3, 2, 0, 0.375}}, {0x1p30, 7, 0}).value();
  CHECK(weighted.error.maxCoeff() == 0);
  CHECK(weighted.points[0][0] == -0x1p31);
  Draw draw(22);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    const double w = round % 2 == 0 ? 1 : draw.number(0.1, 8);
    const double x = draw.number(-1, 1) * std::ldexp(1, round % 30);
    const double origin = draw.number(-1, 1) * std::ldexp(1, round % 17);
    const ControlNet net = ControlNet::of({1}, {{x, 0, 0, w}, {x, 0, 0, w}}, {origin, 0, 0}).value();
    const Rational moved = exactly(x) - exactly(origin) * exactly(w);
    // One more rounding in adding up the bound.
    CHECK_FALSE(exactly(net.error[0] * (1 + 0x1p-50)) < magnitude(exactly(net.points[0][0]) - moved));
    CHECK(net.polynomial == (w == 1));
  }
}
