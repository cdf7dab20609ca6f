// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "solvers.hpp"

namespace eliminant::comparisons {

struct System {
  std::string name;
  Curves curves;
  /// Set for the dense pairs of 10-bit coefficients, from which the growth is taken.
  long dense_degree = 0;
};

/// What is compared, the same at every run: dense pairs (those of the other benchmarks), the examples of the paper, and
/// grids. A sheared grid is the image of a grid under (x, y) -> (x + y, x - 2y), so that no curve is a union of
/// parallels to an axis.
std::vector<System> systems();

}  // namespace eliminant::comparisons
