// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

using bridge::DoubleInterval;

/// Homogeneous coordinates, the weight last, and their two partial derivatives.
template <class Number>
struct JetOf {
  std::array<Number, 4> value{};
  std::array<std::array<Number, 4>, 2> derivative{};
};
using SurfaceJet = JetOf<DoubleInterval>;

/// A tensor-product surface over the product of two projective lines, each in two charts: the parameter a or its
/// inverse. Coordinates in a chart are those of the map times a power of the parameter.
class SurfaceCharts {
 public:
  explicit SurfaceCharts(const symbolic::RationalSurface& surface);

  /// Encloses the coordinates and their derivatives by the chart's parameters on a box.
  SurfaceJet jet(const std::array<bool, 2>& inverted, const std::array<DoubleInterval, 2>& at) const;
  /// Approximately, and much faster.
  JetOf<double> approximate_jet(const std::array<bool, 2>& inverted, const std::array<double, 2>& at) const;
  /// Encloses the coordinates alone.
  std::array<DoubleInterval, 4> value(const std::array<bool, 2>& inverted,
                                      const std::array<DoubleInterval, 2>& at) const;
  /// The charts in which all coordinates vanish at the origin: a base point, near which others serve better.
  bool has_base_point(const std::array<bool, 2>& inverted) const;

 private:
  /// Of u^i v^j in a chart.
  std::size_t index(std::size_t coordinate, std::size_t i, std::size_t j, const std::array<bool, 2>& inverted) const;
  template <class Number>
  JetOf<Number> jet_of(const std::vector<Number>& coefficients, const std::array<bool, 2>& inverted,
                       const std::array<Number, 2>& at) const;

  std::array<std::size_t, 2> degree_{};
  /// Coordinate by coordinate, of u^i v^j at i (n + 1) + j; scaled by a power of two.
  std::vector<DoubleInterval> coefficients_;
  std::vector<double> middles_;
};

/// The least enclosure in doubles.
DoubleInterval enclose(const bridge::RealBall& value);

/// The least enclosure of a rational number times 2^exponent in doubles.
DoubleInterval enclose(const symbolic::Rational& value, long exponent = 0);

/// Encloses the inverse; everything when 0 is inside.
inline DoubleInterval inverse(const DoubleInterval& a) { return DoubleInterval(1) / a; }
inline double middle(const DoubleInterval& a) { return 0.5 * a.lower + 0.5 * a.upper; }
inline double width(const DoubleInterval& a) { return a.upper - a.lower; }
inline bool overlap(const DoubleInterval& a, const DoubleInterval& b) {
  return !(a.upper < b.lower || b.upper < a.lower);
}
inline bool contains(const DoubleInterval& outer, const DoubleInterval& inner) {
  return outer.lower <= inner.lower && inner.upper <= outer.upper;
}
inline DoubleInterval hull(const DoubleInterval& a, const DoubleInterval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

}  // namespace eliminant::intersect
