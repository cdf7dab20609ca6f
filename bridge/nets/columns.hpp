// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <Eigen/Core>

namespace eliminant::bridge {

using Eigen::Array4d;

/// A square matrix of order N <= 3 by columns; lane i is row i, lanes from N on are 0.
using Columns = std::array<Array4d, 3>;

inline Array4d times(const Columns& m, const Array4d& v) { return m[0] * v[0] + m[1] * v[1] + m[2] * v[2]; }

inline Columns absolute(const Columns& m) { return {m[0].abs(), m[1].abs(), m[2].abs()}; }

/// The transposed cofactors of a matrix given by columns, again by columns, and the determinant.
template <std::size_t N>
std::pair<Columns, double> adjugate(const Columns& m) {
  Columns result{Array4d::Zero(), Array4d::Zero(), Array4d::Zero()};
  if constexpr (N == 2) {
    result[0] << m[1][1], -m[0][1], 0, 0;
    result[1] << -m[1][0], m[0][0], 0, 0;
    return {result, m[0][0] * m[1][1] - m[1][0] * m[0][1]};
  } else {
    const auto cross = [](const Array4d& a, const Array4d& b) {
      return Array4d(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0);
    };
    // Row i of the adjugate is orthogonal to the other two columns.
    const std::array<Array4d, 3> rows{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    for (long k = 0; k < 3; ++k) result[static_cast<std::size_t>(k)] = Array4d(rows[0][k], rows[1][k], rows[2][k], 0);
    return {result, rows[0][0] * m[0][0] + rows[0][1] * m[0][1] + rows[0][2] * m[0][2]};
  }
}

}  // namespace eliminant::bridge
