// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::symbolic {

/// The closed interval [lower, upper], lower <= upper.
struct Interval {
  Rational lower;
  Rational upper;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// What belongs to a surface of its two affine parameters (a, b): a closed rectangle, or with `triangle` the set
/// a >= 0, b >= 0, a + b <= 1 (then the rectangle is [0, 1] x [0, 1]).
struct ParameterRegion {
  std::array<Interval, 2> sides;
  bool triangle = false;
};

}  // namespace eliminant::symbolic
