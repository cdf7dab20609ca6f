// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace eliminant::bridge {

/// A box of parameters of both patches.
struct CellBox {
  std::array<double, 4> lower{};
  std::array<double, 4> upper{};
};

/// A part of a border curve of one patch that lies in the other: the parameter of that axis (u, v, s, t) is 0 for side
/// -1 and 1 for side 1, the other parameter of that patch runs from `lower` to `upper`.
struct ContainedBorder {
  std::size_t axis = 0;
  int side = -1;
  double lower = 0;
  double upper = 1;
  /// The border is one point.
  bool one_point = false;

  /// Whether a pair of parameters is on it, as far as its accuracy goes.
  bool holds(const std::array<double, 4>& at, double radius) const {
    const std::size_t along = axis < 2 ? 1 - axis : 5 - axis;
    const double end = side < 0 ? 0 : 1;
    return at[axis] - radius <= end && end <= at[axis] + radius && at[along] + radius >= lower &&
           at[along] - radius <= upper;
  }
};

}  // namespace eliminant::bridge
