// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

#include <eliminant/bridge/contacts/exact_contact.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

/// Bezier curves and patches with planted common points, from polynomials in the power basis.
namespace eliminant::test {

using symbolic::Rational;

/// Coefficients in ascending order.
using Powers = std::vector<Rational>;

inline Powers powers(std::initializer_list<long> coefficients) {
  Powers result;
  for (const long c : coefficients) result.emplace_back(c);
  return result;
}

inline const Powers one = powers({1});
inline const Powers zero = powers({0});
inline const Powers t = powers({0, 1});

inline Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

inline Powers operator+(const Powers& a, const Powers& b) {
  Powers sum(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] = sum[i] + a[i];
  for (std::size_t i = 0; i < b.size(); ++i) sum[i] = sum[i] + b[i];
  return sum;
}

inline Powers operator*(const Powers& a, const Powers& b) {
  Powers product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] = product[i + j] + a[i] * b[j];
  return product;
}

/// (q t - p)^k for the root p / q.
inline Powers root(long p, long q, unsigned k = 1) {
  Powers result = powers({1});
  for (unsigned i = 0; i < k; ++i) result = result * powers({-p, q});
  return result;
}

/// The curve (x, y, z, w)(t) on [0, 1].
inline bridge::ExactNet curve_net(std::array<Powers, 4> coordinates) {
  std::size_t size = 2;
  for (const Powers& c : coordinates) size = std::max(size, c.size());
  bridge::ExactNet net{{size - 1}, std::vector<bridge::ExactPoint>(size)};
  for (std::size_t k = 0; k < 4; ++k) {
    coordinates[k].resize(size);
    const std::vector<Rational> values = symbolic::bernstein_coefficients(coordinates[k], {0, 1});
    for (std::size_t i = 0; i < size; ++i) net.points[i][k] = values[i];
  }
  return net;
}

/// The patch (s, t, a s t + b (s^2 + t^2)) on [0, 1]^2, of bidegree (2, 2).
inline bridge::ExactNet saddle_net(long a, long b) {
  bridge::ExactNet net{{2, 2}, {}};
  for (long i = 0; i <= 2; ++i)
    for (long j = 0; j <= 2; ++j) {
      const Rational s = Rational(i) / Rational(2);
      const Rational t = Rational(j) / Rational(2);
      const Rational squares = Rational(i == 2 ? 1 : 0) + Rational(j == 2 ? 1 : 0);
      net.points.push_back({s, t, Rational(a) * s * t + Rational(b) * squares, Rational(1)});
    }
  return net;
}

/// Its third coordinate along (s, t)(t).
inline Powers on_saddle(long a, long b, const Powers& s, const Powers& t) {
  return powers({a}) * s * t + powers({b}) * (s * s + t * t);
}

/// Every point mapped by a matrix of homogeneous coordinates, by rows.
inline void transform(bridge::ExactNet& net, const std::array<std::array<long, 4>, 4>& rows) {
  for (bridge::ExactPoint& point : net.points) {
    bridge::ExactPoint image;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k) image[i] = image[i] + Rational(rows[i][k]) * point[k];
    point = image;
  }
}

/// In doubles, with the origin where it is.
inline bridge::ControlNet in_doubles(const bridge::ExactNet& net) {
  return bridge::ControlNet::round(net.degrees, net.points, {}).value();
}

}  // namespace eliminant::test
