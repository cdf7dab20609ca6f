// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/patch_border_points.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::intersect {

/// The border curves of two patches on [0, 1]^2, against each other; each pair is intersected once.
class BorderCurves {
 public:
  /// All must outlive the object.
  BorderCurves(const bridge::ExactNet& first, const bridge::ExactNet& second, const Context& context)
      : first_(first), second_(second), context_(context) {}

  /// The certified common points of a border curve of the first patch (the parameter of that axis, 0 or 1, has its
  /// lower bound for side -1, its upper one for side 1) and one of the second (axis 2 or 3), by their parameters on the
  /// curves.
  const std::vector<std::array<double, 2>>& meetings(std::size_t first_axis, int first_side, std::size_t second_axis,
                                                     int second_side);

  /// What is certified of a border curve (axis 0 to 3) against the other patch.
  bridge::ContainedParts contained(std::size_t axis, int side) const;

 private:
  /// first_axis, first_side, second_axis, second_side.
  using PairOfBorders = std::tuple<std::size_t, int, std::size_t, int>;

  std::vector<std::array<double, 2>> intersect(const PairOfBorders& borders) const;

  const bridge::ExactNet& first_;
  const bridge::ExactNet& second_;
  const Context& context_;
  std::map<PairOfBorders, std::vector<std::array<double, 2>>> known_;
};

}  // namespace eliminant::intersect
