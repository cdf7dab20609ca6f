// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// Where a curve meets the curves of a surface on which one parameter is fixed: conditions on t, each computed when it
/// is first asked, by which equality with a border is decided exactly.
class SurfaceBorders {
 public:
  /// All must outlive the object.
  SurfaceBorders(const symbolic::RationalSurface& surface, const symbolic::RationalCurve& curve, std::uint64_t seed,
                 const Context& context)
      : surface_(surface), curve_(curve), seed_(seed), context_(context) {}

  /// The condition for the curve where affine parameter `group` is `value` (nullopt: infinity), or homogeneous
  /// parameter `group` of a triangular surface is 0. Zero when the curve lies in it, or it consists of base points.
  const symbolic::ParameterForm& condition(std::size_t group, const std::optional<symbolic::Rational>& value);
  /// Whether the point lies on that curve of the surface.
  bool contains(const PointOnCurve& point, std::size_t group, const std::optional<symbolic::Rational>& value);
  /// The same for the line at infinity of the map over the projective plane.
  bool at_line_at_infinity(const PointOnCurve& point, const symbolic::RationalSurface& over_the_plane);

 private:
  symbolic::ParameterForm meeting_condition(const std::optional<symbolic::RationalCurve>& border) const;

  const symbolic::RationalSurface& surface_;
  const symbolic::RationalCurve& curve_;
  std::uint64_t seed_;
  const Context& context_;
  std::map<std::pair<std::size_t, std::string>, symbolic::ParameterForm> conditions_;
  std::optional<symbolic::ParameterForm> line_at_infinity_;
};

}  // namespace eliminant::intersect
