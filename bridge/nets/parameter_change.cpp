// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/parameter_change.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/enclosures/ball.hpp>

#include <flint/fmpq.h>

namespace eliminant::bridge {

namespace {

using symbolic::Integer;
using symbolic::Rational;

/// Of the numbers in Newton's method, and of the rational numbers that are read from them: half of them must be free.
constexpr long working_bits = 768;
constexpr long largest_height_bits = 300;

Rational power_of_two(long exponent) {
  Rational result;
  fmpz_one_2exp(exponent < 0 ? fmpq_denref(result.get()) : fmpq_numref(result.get()),
                static_cast<ulong>(exponent < 0 ? -exponent : exponent));
  fmpz_one(exponent < 0 ? fmpq_numref(result.get()) : fmpq_denref(result.get()));
  return result;
}

Rational shortened(const Rational& value) {
  RealBall ball;
  arb_set_fmpq(ball.get(), value.get(), working_bits);
  Rational result;
  arf_get_fmpq(result.get(), arb_midref(ball.get()));
  return result;
}

bool is_below(const Rational& value, const Rational& bound) { return value < bound && -bound < value; }

/// The simplest rational number next to the value.
std::optional<Rational> simplest_near(const Rational& value) {
  const Rational accuracy = power_of_two(-working_bits + 64);
  Rational result;
  fmpq_simplest_between(result.get(), (value - accuracy).get(), (value + accuracy).get());
  if (fmpq_height_bits(result.get()) > static_cast<ulong>(largest_height_bits)) return std::nullopt;
  return result;
}

/// One step of de Casteljau's algorithm with homogeneous parameters (near : far).
void blend(std::vector<ExactPoint>& line, std::size_t count, const Rational& near, const Rational& far) {
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 4; ++k) line[i][k] = near * line[i][k] + far * line[i + 1][k];
}

/// Control points of a line of them, after the map.
std::vector<ExactPoint> composed_line(const std::vector<ExactPoint>& line, const ProjectiveMap& map) {
  const std::size_t degree = line.size() - 1;
  std::vector<ExactPoint> result;
  for (std::size_t k = 0; k <= degree; ++k) {
    std::vector<ExactPoint> blossom = line;
    std::size_t count = degree;
    // Values of (1 - x : x) at both ends, up to the common denominator of each.
    for (std::size_t i = 0; i < degree - k; ++i) blend(blossom, count--, map.d - map.b, map.b);
    for (std::size_t i = 0; i < k; ++i) blend(blossom, count--, map.c + map.d - map.a - map.b, map.a + map.b);
    result.push_back(blossom.front());
  }
  return result;
}

struct ExactJet {
  ExactPoint value;
  std::array<ExactPoint, 2> first;
};

/// Value and derivative of a line of control points.
std::array<ExactPoint, 2> line_jet(std::vector<ExactPoint> line, const Rational& t) {
  const std::size_t degree = line.size() - 1;
  const Rational near = Rational(1) - t;
  for (std::size_t count = degree; count > 1; --count) blend(line, count, near, t);
  ExactPoint slope;
  for (std::size_t k = 0; k < 4; ++k) slope[k] = Rational(static_cast<long>(degree)) * (line[1][k] - line[0][k]);
  blend(line, 1, near, t);
  return {line[0], slope};
}

ExactJet jet_at(const ExactNet& net, const std::array<Rational, 2>& at) {
  const std::size_t row = net.degrees[1] + 1;
  std::array<std::vector<ExactPoint>, 2> lines;
  for (std::size_t i = 0; i <= net.degrees[0]; ++i) {
    const auto begin = net.points.begin() + static_cast<std::ptrdiff_t>(i * row);
    auto jet = line_jet({begin, begin + static_cast<std::ptrdiff_t>(row)}, at[1]);
    for (std::size_t k = 0; k < 2; ++k) lines[k].push_back(std::move(jet[k]));
  }
  auto along = line_jet(std::move(lines[0]), at[0]);
  return {std::move(along[0]), {std::move(along[1]), line_jet(std::move(lines[1]), at[0])[0]}};
}

using Pair = std::array<Rational, 2>;

/// Parameters on a patch of points of another one.
class Inversion {
 public:
  Inversion(const ExactNet& first, const ExactNet& second) : first_(first), second_(second) {}

  /// The rational parameters of the second patch near `near` at which it has the point of the first one at `at`.
  std::optional<Pair> image(const Pair& at, Pair near) const {
    const ExactPoint point = jet_at(first_, at).value;
    if (point[3].is_zero()) return std::nullopt;
    constexpr int most_steps = 14;
    const Rational converged = power_of_two(-working_bits + 96);
    for (int step = 0; step < most_steps; ++step) {
      const ExactJet jet = jet_at(second_, near);
      const auto move = newton_step(jet, point);
      if (!move) return std::nullopt;
      for (std::size_t k = 0; k < 2; ++k) near[k] = shortened(near[k] - (*move)[k]);
      if (!is_below(near[0], 64) || !is_below(near[1], 64)) return std::nullopt;
      if (is_below((*move)[0], converged) && is_below((*move)[1], converged)) return rational(near, point);
    }
    return std::nullopt;
  }

 private:
  /// For the two affine coordinates that depend on the parameters most.
  static std::optional<Pair> newton_step(const ExactJet& jet, const ExactPoint& point) {
    std::array<Rational, 3> difference;
    std::array<Pair, 3> slope;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational x = point[k] / point[3];
      difference[k] = shortened(jet.value[k] - x * jet.value[3]);
      for (std::size_t i = 0; i < 2; ++i) slope[k][i] = shortened(jet.first[i][k] - x * jet.first[i][3]);
    }
    Rational best;
    std::array<std::size_t, 2> rows{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t l = 0; l < k; ++l) {
        Rational minor = slope[k][0] * slope[l][1] - slope[k][1] * slope[l][0];
        if (is_below(minor, best.sign() < 0 ? -best : best) || minor.is_zero()) continue;
        best = std::move(minor);
        rows = {k, l};
      }
    if (best.is_zero()) return std::nullopt;
    const auto& [k, l] = rows;
    return Pair{(difference[k] * slope[l][1] - slope[k][1] * difference[l]) / best,
                (slope[k][0] * difference[l] - difference[k] * slope[l][0]) / best};
  }

  /// As rational numbers, if they have the point exactly.
  std::optional<Pair> rational(const Pair& near, const ExactPoint& point) const {
    const auto a = simplest_near(near[0]);
    const auto b = simplest_near(near[1]);
    if (!a || !b) return std::nullopt;
    const ExactPoint there = jet_at(second_, {*a, *b}).value;
    for (std::size_t k = 0; k < 3; ++k)
      if (!(there[k] * point[3] == point[k] * there[3])) return std::nullopt;
    return Pair{*a, *b};
  }

  const ExactNet& first_;
  const ExactNet& second_;
};

Rational dyadic(double value) {
  // Few bits keep all numbers short.
  constexpr double steps = 1024;
  Rational result;
  RealBall ball;
  arb_set_d(ball.get(), std::nearbyint(value * steps) / steps);
  arf_get_fmpq(result.get(), arb_midref(ball.get()));
  return result;
}

}  // namespace

std::optional<Rational> ProjectiveMap::at(const Rational& x) const {
  const Rational denominator = c * x + d;
  if (denominator.is_zero()) return std::nullopt;
  return (a * x + b) / denominator;
}

std::optional<ProjectiveMap> ProjectiveMap::through(const std::array<Rational, 3>& from,
                                                    const std::array<Rational, 3>& to) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (from[i] == from[j] || to[i] == to[j]) return std::nullopt;
  // By the cross-ratios (x - x0)(x1 - x2) : (x - x2)(x1 - x0), which both have.
  const auto to_cross_ratio = [](const std::array<Rational, 3>& x) {
    const Rational p = x[1] - x[2];
    const Rational q = x[1] - x[0];
    return ProjectiveMap{p, -(p * x[0]), q, -(q * x[2])};
  };
  const ProjectiveMap before = to_cross_ratio(from);
  const ProjectiveMap after = to_cross_ratio(to).inverse();
  return ProjectiveMap{after.a * before.a + after.b * before.c, after.a * before.b + after.b * before.d,
                       after.c * before.a + after.d * before.c, after.c * before.b + after.d * before.d};
}

ExactNet composed(const ExactNet& net, std::size_t axis, const ProjectiveMap& map) {
  ExactNet result = net;
  const std::size_t row = net.degrees[1] + 1;
  const std::size_t lines = net.degrees[1 - axis] + 1;
  for (std::size_t line = 0; line < lines; ++line) {
    const auto place = [&](std::size_t i) { return axis == 0 ? i * row + line : line * row + i; };
    std::vector<ExactPoint> points;
    for (std::size_t i = 0; i <= net.degrees[axis]; ++i) points.push_back(net.points[place(i)]);
    points = composed_line(points, map);
    for (std::size_t i = 0; i <= net.degrees[axis]; ++i) result.points[place(i)] = std::move(points[i]);
  }
  return result;
}

bool is_same_map(const ExactNet& first, const ExactNet& second, const ParameterChange& change) {
  ExactNet other = second;
  if (change.exchanged) {
    std::swap(other.degrees[0], other.degrees[1]);
    for (std::size_t i = 0; i <= other.degrees[0]; ++i)
      for (std::size_t j = 0; j <= other.degrees[1]; ++j)
        other.points[i * (other.degrees[1] + 1) + j] = second.points[j * (other.degrees[0] + 1) + i];
  }
  if (other.degrees != first.degrees) return false;
  for (std::size_t axis = 0; axis < 2; ++axis) other = composed(other, axis, change.maps[axis]);
  // Proportional, all coordinates of all points together.
  const Rational* scale = nullptr;
  const Rational* other_scale = nullptr;
  for (std::size_t i = 0; i < first.points.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const Rational& x = first.points[i][k];
      const Rational& y = other.points[i][k];
      if (x.is_zero() != y.is_zero()) return false;
      if (x.is_zero()) continue;
      if (scale == nullptr) {
        scale = &x;
        other_scale = &y;
      } else if (!(x * *other_scale == y * *scale)) {
        return false;
      }
    }
  return scale != nullptr;
}

std::optional<ParameterChange> parameter_change(const ExactNet& first, const ExactNet& second,
                                                const std::array<double, 4>& start) {
  std::vector<std::size_t> degrees = first.degrees;
  std::vector<std::size_t> others = second.degrees;
  std::sort(degrees.begin(), degrees.end());
  std::sort(others.begin(), others.end());
  if (degrees != others) return std::nullopt;
  const Inversion inversion(first, second);
  const Pair at{dyadic(start[0]), dyadic(start[1])};
  const auto image = inversion.image(at, {dyadic(start[2]), dyadic(start[3])});
  if (!image) return std::nullopt;
  ParameterChange change;
  const Rational step(Integer(1), Integer(32));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::array<Rational, 3> from{at[axis], {}, {}};
    std::array<Pair, 3> to{*image, {}, {}};
    for (std::size_t i = 1; i < 3; ++i) {
      Pair next = at;
      from[i] = next[axis] =
          at[axis] + (at[axis] < Rational(Integer(1), Integer(2)) ? step : -step) * Rational(static_cast<long>(i));
      const auto found = inversion.image(next, to[i - 1]);
      if (!found) return std::nullopt;
      to[i] = *found;
    }
    // One of both parameters moves alone.
    const std::size_t moving = to[1][0] == to[0][0] ? 1 : 0;
    const bool exchanged = moving != axis;
    if (axis == 1 && exchanged != change.exchanged) return std::nullopt;
    change.exchanged = exchanged;
    const auto map = ProjectiveMap::through(from, {to[0][moving], to[1][moving], to[2][moving]});
    if (!map) return std::nullopt;
    change.maps[axis] = *map;
  }
  if (!is_same_map(first, second, change)) return std::nullopt;
  return change;
}

}  // namespace eliminant::bridge
