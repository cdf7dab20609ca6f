// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/prepared_patch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::intersect {

namespace {

using bridge::nearest;
using symbolic::Rational;

/// Weights of one sign are made positive.
void make_weights_positive(PreparedNet& net) {
  const bool negative =
      std::all_of(net.exact.points.begin(), net.exact.points.end(), [](const auto& p) { return p[3].sign() < 0; });
  if (!negative) return;
  for (bridge::ExactPoint& point : net.exact.points)
    for (Rational& coordinate : point) coordinate = Rational(0) - coordinate;
}

/// By which power of two c the control points of row i (column, for axis 1) must be multiplied, c^i, so that their
/// weights do not rise or fall: u / (1 - u) is c times the new parameter's.
long balance_exponent(const PreparedNet& net, std::size_t axis) {
  const std::size_t m = net.exact.degrees[0];
  const std::size_t n = net.exact.degrees[1];
  const std::size_t lines = axis == 0 ? n : m;
  const std::size_t degree = axis == 0 ? m : n;
  const auto weight = [&](std::size_t line, std::size_t i) {
    return std::log2(nearest(net.exact.points[axis == 0 ? i * (n + 1) + line : line * (n + 1) + i][3]));
  };
  double sum = 0;
  for (std::size_t line = 0; line <= lines; ++line) sum += weight(line, 0) - weight(line, degree);
  const double slope = sum / static_cast<double>((lines + 1) * degree);
  return std::isfinite(slope) ? std::lround(slope) : 0;
}

/// Multiplies all coordinates of row i by 2^(e i).
void balance(PreparedNet& net, std::size_t axis, long exponent) {
  if (exponent == 0) return;
  const std::size_t row = net.exact.degrees[1] + 1;
  for (std::size_t i = 0; i < net.exact.points.size(); ++i) {
    const auto power = static_cast<long>(axis == 0 ? i / row : i % row) * exponent;
    Rational factor;
    fmpz_one_2exp(fmpq_numref(factor.get()), static_cast<ulong>(std::max(power, 0L)));
    fmpz_one_2exp(fmpq_denref(factor.get()), static_cast<ulong>(std::max(-power, 0L)));
    for (Rational& coordinate : net.exact.points[i]) coordinate = coordinate * factor;
  }
}

}  // namespace

PreparedNet prepared_patch(const symbolic::SurfacePiece& piece, const char* which) {
  if (auto net = prepared_net(piece)) {
    make_weights_positive(*net);
    return *std::move(net);
  }
  throw InvalidInput(std::string("the ") + which +
                     " surface is no patch: a tensor-product map that depends on both parameters, on a domain of "
                     "positive area, was expected");
}

bool has_positive_weights(const PreparedNet& net) {
  return std::all_of(net.exact.points.begin(), net.exact.points.end(), [](const auto& p) { return p[3].sign() > 0; });
}

double size_of(const PreparedNet& net) {
  std::array<double, 3> lower;
  std::array<double, 3> upper;
  lower.fill(INFINITY);
  upper.fill(-INFINITY);
  for (const bridge::ExactPoint& point : net.exact.points) {
    if (point[3].is_zero()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = nearest(point[k] / point[3]);
      lower[k] = std::min(lower[k], x);
      upper[k] = std::max(upper[k], x);
    }
  }
  return std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
}

double balance_weights(PreparedNet& net, std::size_t axis) {
  const long exponent = balance_exponent(net, axis);
  balance(net, axis, exponent);
  return std::ldexp(1.0, static_cast<int>(exponent));
}

}  // namespace eliminant::intersect
