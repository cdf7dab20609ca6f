// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/enclosed_patch.hpp>

namespace eliminant::bridge {

/// A part of a patch as a graph over the plane of the first two coordinates, from enclosures of its derivatives. As
/// entries are enclosed one by one, all of it also holds of mean values of the derivatives, of each coordinate its own.
struct GraphSlopes {
  /// The derivatives by parameters that were changed linearly, so that along the plane they are near the identity.
  std::array<EnclosedPatch::Point, 2> slope;
  /// Bounds how far they are from it, in the maximum norm. Below 1 the part is a graph.
  double contraction = 0;
  /// The inverse of the derivative along the plane, by the parameter, then by the coordinate; everything where the part
  /// may be none.
  std::array<std::array<DoubleInterval, 2>, 2> solve;
  /// The normal, its last component being 1: the others are the slopes of the graph, with opposite signs.
  EnclosedPatch::Point normal;

  /// The parameters are changed by the matrix `inverse`, by rows.
  GraphSlopes(const std::array<EnclosedPatch::Point, 2>& derivatives,
              const std::array<std::array<double, 2>, 2>& inverse);
};

}  // namespace eliminant::bridge
