// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/bridge/contacts/contact_series.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>

namespace eliminant::bridge {

/// Affine coordinates of a patch and their partial derivatives, enclosed for all points of a box of parameters; in the
/// frame of the table.
struct EnclosedPatch {
  using Point = std::array<DoubleInterval, 3>;
  Point value;
  /// By u and v.
  std::array<Point, 2> first;
  /// By uu, uv and vv.
  std::array<Point, 3> second;

  /// From the Taylor coefficients on the box, of order 2 at least.
  explicit EnclosedPatch(const TaylorTable<DoubleInterval>& table);
};

}  // namespace eliminant::bridge
