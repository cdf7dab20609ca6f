// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::intersect {

/// Points drawn in order, relative to the origin of the nets.
struct DrawnCurve {
  std::vector<std::array<double, 4>> parameters;
  std::vector<std::array<double, 3>> points;
  /// Bounds the distance of the polyline from the true curve, and the other way round.
  double error = 0;
};

/// The part of a border curve of one of two patches that lies in the other. Chords keep to the tolerance, as far as
/// 10^6 points reach; the ends of the part are taken to be known to 15 digits.
DrawnCurve drawn_border(const bridge::ControlNet& first, const bridge::ControlNet& second,
                        const bridge::ContainedBorder& border, double tolerance);

}  // namespace eliminant::intersect
