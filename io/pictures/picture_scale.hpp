// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include <eliminant/io/pictures/picture.hpp>

namespace eliminant::io {

struct PictureRange {
  double lower = 0;
  double upper = 1;

  bool contains(double x) const { return lower <= x && x <= upper; }
};

/// A tick, where it is drawn and how it is named.
struct PictureTick {
  double at = 0;
  std::string name;
};

/// What of the plane of a panel is shown, in drawn coordinates: its border and a little more, or everything; of an
/// unbounded one where most of the points are.
std::array<PictureRange, 2> view_of(const PicturePanel& panel);

/// A coordinate as it is drawn: of a projective panel from -1 to 1, else itself.
double drawn(const PicturePanel& panel, double coordinate);

/// The points of a curve as they are drawn. Of a projective panel the curve is cut where it runs through infinity, by a
/// point that is not finite.
std::vector<std::array<double, 2>> drawn(const PicturePanel& panel, const PictureCurve& curve);

/// About five round numbers inside the range; of a projective panel always the same.
std::vector<PictureTick> ticks_in(const PicturePanel& panel, const PictureRange& range);

}  // namespace eliminant::io
