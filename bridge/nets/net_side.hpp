// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include <eliminant/bridge/nets/bezier_part.hpp>

namespace eliminant::bridge {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Bounds in each coordinate.
struct Bounds {
  Array4d lower = Array4d::Constant(infinity);
  Array4d upper = Array4d::Constant(-infinity);

  void take(const Array4d& value) {
    lower = lower.min(value);
    upper = upper.max(value);
  }
  Array4d magnitude() const { return lower.abs().max(upper.abs()); }
};

/// The curve or patch of a pair: where its control points are, and what is known of them.
template <std::size_t P>
struct Side {
  NetShape<P> shape;
  bool polynomial = true;
  Array4d* points = nullptr;
  Array4d error;
  /// Largest absolute value of each homogeneous coordinate, error included.
  Array4d size;
  /// Around the points of the part, weights divided out.
  Bounds box;
  /// Middle of the range of the weights; the weights are this times 1 + delta with |delta| <= weight_spread.
  double weight = 1;
  double weight_spread = 0;
};

/// False when a weight may not be positive.
template <std::size_t P>
bool bound(Side<P>& side) {
  const std::size_t count = side.shape.size();
  Bounds homogeneous;
  for (std::size_t i = 0; i < count; ++i) homogeneous.take(side.points[i]);
  side.size = homogeneous.magnitude() + side.error;
  if (side.polynomial) {
    side.box = homogeneous;
    side.box.lower -= side.error;
    side.box.upper += side.error;
    return true;
  }
  const double lowest = homogeneous.lower[3] - side.error[3];
  const double highest = homogeneous.upper[3] + side.error[3];
  if (!(lowest > side.error[3]) || !(highest < infinity)) return false;
  side.weight = 0.5 * (lowest + highest);
  side.weight_spread = (0.5 * (highest - lowest) / side.weight) * (1 + 8 * unit_roundoff) + 4 * unit_roundoff;
  side.box = Bounds();
  for (std::size_t i = 0; i < count; ++i) side.box.take(side.points[i] / side.points[i][3]);
  const Array4d largest = side.box.magnitude();
  const Array4d slack = (side.error + largest * side.error[3]) * (1.001 / lowest) + 4 * unit_roundoff * largest;
  side.box.lower -= slack;
  side.box.upper += slack;
  return true;
}

/// The derivative by a local parameter from one end to the other, weights divided out.
template <std::size_t P>
Array4d secant(const Side<P>& side, std::size_t axis) {
  const auto point = [&](std::size_t i) -> Array4d {
    return side.polynomial ? side.points[i] : side.points[i] / side.points[i][3];
  };
  const std::size_t last = side.shape.size() - 1;
  if constexpr (P == 1) {
    return 0.5 * (point(last) - point(0));
  } else {
    const std::size_t end = side.shape.degree[axis] * side.shape.stride(axis);
    return 0.25 * ((point(end) - point(0)) + (point(last) - point(last - end)));
  }
}

template <std::size_t P>
Array4d moved_size(const Side<P>& side, const Array4d& shift) {
  return (side.size + shift.abs() * side.size[3]) / side.weight;
}

template <std::size_t P>
Array4d moved_error(const Side<P>& side, const Array4d& shift) {
  return (side.error + shift.abs() * side.error[3]) / side.weight;
}

}  // namespace eliminant::bridge
