// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/injectivity.hpp>
#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// A rectangle of the parameters of a patch, cut out exactly.
struct PatchPart {
  /// In [0, 1], exactly and rounded outwards.
  std::array<symbolic::Interval, 2> sides;
  bridge::ParameterRectangle rectangle;
  /// Around the part in space; everything where a weight may not be positive.
  std::array<double, 3> lower{};
  std::array<double, 3> upper{};
};

bool apart(const PatchPart& a, const PatchPart& b);

/// A patch with weights of one sign, cut into four again and again where that is asked for. Trees of different `kind`
/// (0 or 1) are cut at different places, and none in the middle, so that curves of symmetric patches do not pass
/// through corners of pairs of parts.
class PartTree {
 public:
  /// Boxes in space are relative to the origin, one of the patch's own where none is given: parts of trees that are
  /// compared have the same.
  PartTree(const symbolic::SurfacePiece& patch, std::size_t kind,
           const std::optional<std::array<symbolic::Rational, 3>>& origin = std::nullopt);

  const PatchPart& part(std::size_t index) const { return parts_[index]; }
  /// The four parts of a part, cut now if they are not there yet. References to parts become invalid.
  std::array<std::size_t, 4> children(std::size_t index);
  /// The control points of a part.
  const PreparedNet& net(std::size_t index);

 private:
  std::size_t add(const std::array<symbolic::Interval, 2>& sides);

  symbolic::SurfacePiece patch_;
  std::size_t kind_;
  std::optional<bridge::ControlNet> rounded_;
  std::vector<PatchPart> parts_;
  std::vector<std::optional<std::size_t>> first_child_;
  std::vector<std::optional<PreparedNet>> nets_;
};

}  // namespace eliminant::intersect
