// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include <support/bezier_case.hpp>

/// Pairs of patches in plain doubles, for tests, benchmarks and programs that link other libraries.
namespace eliminant::test {

/// What two patches have in common, in numbers: arcs from border or singular point to border or singular point, smooth
/// closed curves, isolated points, points at which the curve is singular (isolated points of contact among them).
struct PatchCounts {
  unsigned long curves = 0;
  unsigned long loops = 0;
  unsigned long points = 0;
  unsigned long singular = 0;

  friend bool operator==(const PatchCounts&, const PatchCounts&) = default;
};

inline std::ostream& operator<<(std::ostream& out, const PatchCounts& counts) {
  return out << counts.curves << " curves, " << counts.loops << " loops, " << counts.points << " points, "
             << counts.singular << " singular";
}

/// Two tensor-product Bezier patches over [0, 1] x [0, 1], or one with itself.
struct PatchCase {
  std::string family;
  /// First in its family is 0; the same case at every run.
  unsigned long index = 0;
  ControlNet first;
  ControlNet second;  ///< empty for one patch with itself
  /// Where the construction says it.
  std::optional<PatchCounts> planted;
};

}  // namespace eliminant::test
