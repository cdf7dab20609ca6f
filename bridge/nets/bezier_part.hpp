// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace eliminant::bridge {

using Eigen::Array4d;

/// How the control points of a Bezier curve (P = 1) or tensor-product patch (P = 2) lie in memory: the last parameter
/// runs fastest.
template <std::size_t P>
struct NetShape {
  std::array<std::size_t, P> degree{};

  std::size_t size() const {
    std::size_t result = 1;
    for (const std::size_t d : degree) result *= d + 1;
    return result;
  }
  std::size_t stride(std::size_t axis) const { return axis + 1 == P ? 1 : degree[P - 1] + 1; }
  /// Calls with the first index of every line of control points along an axis.
  template <class Visit>
  void for_each_line(std::size_t axis, Visit visit) const {
    if constexpr (P == 1) {
      visit(std::size_t{0});
    } else if (axis == 0) {
      for (std::size_t j = 0; j <= degree[1]; ++j) visit(j);
    } else {
      for (std::size_t i = 0; i <= degree[0]; ++i) visit(i * (degree[1] + 1));
    }
  }
};

/// A double operation rounds by at most this, relatively.
inline constexpr double unit_roundoff = 0x1p-53;

/// Both halves along an axis by de Casteljau's algorithm: `left` holds the whole and becomes the first half.
/// Every control value is wrong by at most degree * unit_roundoff * (largest value) more.
template <std::size_t P>
void halve(const NetShape<P>& shape, std::size_t axis, Array4d* left, Array4d* right) {
  std::copy(left, left + shape.size(), right);
  const std::size_t degree = shape.degree[axis];
  const std::size_t stride = shape.stride(axis);
  shape.for_each_line(axis, [&](std::size_t base) {
    Array4d* const a = left + base;
    Array4d* const b = right + base;
    for (std::size_t level = 0; level <= degree; ++level) {
      a[level * stride] = b[0];
      for (std::size_t i = 0; i + level < degree; ++i) b[i * stride] = 0.5 * (b[i * stride] + b[(i + 1) * stride]);
    }
  });
}

/// Both parts along an axis, as `halve` does, at a parameter in (0, 1).
/// Every control value is wrong by at most 4 * degree * unit_roundoff * (largest value) more.
template <std::size_t P>
void cut_at(const NetShape<P>& shape, std::size_t axis, double at, Array4d* left, Array4d* right) {
  std::copy(left, left + shape.size(), right);
  const std::size_t degree = shape.degree[axis];
  const std::size_t stride = shape.stride(axis);
  shape.for_each_line(axis, [&](std::size_t base) {
    Array4d* const a = left + base;
    Array4d* const b = right + base;
    for (std::size_t level = 0; level <= degree; ++level) {
      a[level * stride] = b[0];
      for (std::size_t i = 0; i + level < degree; ++i)
        b[i * stride] = (1 - at) * b[i * stride] + at * b[(i + 1) * stride];
    }
  });
}

/// The part between two values of the parameter of an axis, which may lie a little outside [0, 1].
/// Every control value is wrong by at most 10 * degree * unit_roundoff * (largest value met) more.
template <std::size_t P>
void restrict_to(const NetShape<P>& shape, std::size_t axis, double lower, double upper, Array4d* points) {
  const std::size_t degree = shape.degree[axis];
  const std::size_t stride = shape.stride(axis);
  const auto keep_right = [&](Array4d* p, double t) {
    if (t == 0) return;
    for (std::size_t level = 1; level <= degree; ++level)
      for (std::size_t i = 0; i + level <= degree; ++i)
        p[i * stride] = (1 - t) * p[i * stride] + t * p[(i + 1) * stride];
  };
  const auto keep_left = [&](Array4d* p, double t) {
    if (t == 1) return;
    for (std::size_t level = 1; level <= degree; ++level)
      for (std::size_t i = degree; i >= level; --i) p[i * stride] = (1 - t) * p[(i - 1) * stride] + t * p[i * stride];
  };
  shape.for_each_line(axis, [&](std::size_t base) {
    Array4d* const p = points + base;
    if (lower + upper < 1) {
      keep_right(p, lower);
      keep_left(p, (upper - lower) / (1 - lower));
    } else {
      keep_left(p, upper);
      keep_right(p, lower / upper);
    }
  });
}

/// The value at a parameter and the partial derivatives there.
template <std::size_t P>
struct NetJet {
  Array4d value;
  std::array<Array4d, P> partials;
};

/// By de Casteljau's algorithm. The value is wrong by at most 4 * (sum of the degrees) * unit_roundoff * (largest
/// control value), for parameters in [0, 1]; nothing is said of the derivatives. `scratch` has room for the points.
template <std::size_t P>
NetJet<P> jet_at(const NetShape<P>& shape, const Array4d* points, const std::array<double, P>& at, Array4d* scratch) {
  // The points of a line become the value and the slope.
  const auto along = [](Array4d* b, std::size_t degree, std::size_t stride, double t, Array4d& slope) {
    for (std::size_t level = degree; level > 1; --level)
      for (std::size_t i = 0; i < level; ++i) b[i * stride] = (1 - t) * b[i * stride] + t * b[(i + 1) * stride];
    slope = static_cast<double>(degree) * (b[stride] - b[0]);
    b[0] = (1 - t) * b[0] + t * b[stride];
  };
  std::copy(points, points + shape.size(), scratch);
  NetJet<P> result;
  if constexpr (P == 1) {
    along(scratch, shape.degree[0], 1, at[0], result.partials[0]);
  } else {
    const std::size_t row = shape.degree[1] + 1;
    for (std::size_t i = 0; i <= shape.degree[0]; ++i) {
      Array4d slope;
      along(scratch + i * row, shape.degree[1], 1, at[1], slope);
      scratch[i * row + 1] = slope;
    }
    Array4d mixed;
    along(scratch + 1, shape.degree[0], row, at[0], mixed);
    result.partials[1] = scratch[1];
    along(scratch, shape.degree[0], row, at[0], result.partials[0]);
  }
  result.value = scratch[0];
  return result;
}

}  // namespace eliminant::bridge
