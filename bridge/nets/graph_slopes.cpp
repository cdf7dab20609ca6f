// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/graph_slopes.hpp>

#include <algorithm>
#include <cstddef>

namespace eliminant::bridge {

GraphSlopes::GraphSlopes(const std::array<EnclosedPatch::Point, 2>& derivatives,
                         const std::array<std::array<double, 2>, 2>& inverse) {
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t c = 0; c < 3; ++c)
      slope[k][c] =
          derivatives[0][c] * DoubleInterval(inverse[0][k]) + derivatives[1][c] * DoubleInterval(inverse[1][k]);
  for (std::size_t c = 0; c < 2; ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) sum += (slope[k][c] - DoubleInterval(c == k ? 1 : 0)).magnitude();
    contraction = std::max(contraction, sum);
  }
  const DoubleInterval determinant = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
  solve = {{{slope[1][1] / determinant, -slope[1][0] / determinant},
            {-slope[0][1] / determinant, slope[0][0] / determinant}}};
  normal = {-(slope[0][2] * solve[0][0] + slope[1][2] * solve[1][0]),
            -(slope[0][2] * solve[0][1] + slope[1][2] * solve[1][1]), DoubleInterval(1)};
}

}  // namespace eliminant::bridge
