// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include <eliminant/io/picture.hpp>

namespace eliminant::io {

struct PictureRange {
  double lower = 0;
  double upper = 1;

  bool contains(double x) const { return lower <= x && x <= upper; }
};

/// What of the plane of a panel is shown: its border and a little more. Without one everything, or, where some points
/// are far away from most of them, where most of them are.
std::array<PictureRange, 2> view_of(const PicturePanel& panel);

/// Round numbers inside the range, about five of them.
std::vector<double> ticks_in(const PictureRange& range);

std::string tick_text(double tick);

}  // namespace eliminant::io
