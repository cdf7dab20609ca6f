// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/bridge/nets/parameter_change.hpp>
#include <eliminant/intersect/overlaps/border_arc.hpp>
#include <eliminant/intersect/patches/net_patches.hpp>
#include <eliminant/symbolic/geometry/domain.hpp>

namespace eliminant::intersect {

/// Two patches that are parts of one map: the same patch, parts of one that was cut, raised in degree, or given new
/// parameters.
struct SharedMap {
  /// From the parameters of the first patch to those of the second.
  bridge::ParameterChange change;
  /// The parameters of the first patch that belong to both: disjoint closed rectangles, of which some may be segments
  /// or points.
  std::vector<std::array<symbolic::Interval, 2>> parts;
  /// Both patches together are an embedded part of the map: they have nothing in common but the parts.
  bool embedded = false;

  bool has_area() const;
};

/// Whether two patches on [0, 1]^2 are parts of one map by projective changes of each parameter; proven when there is
/// an answer. nullopt decides nothing.
std::optional<SharedMap> shared_map(const PatchNets& first, const PatchNets& second, const Context& context);

/// A part by points in order: along its outline (closed), along the segment, or one point. Chords keep to the
/// tolerance, as far as 10^6 points for each side reach.
DrawnCurve drawn_part(const bridge::ControlNet& first, const bridge::ParameterChange& change,
                      const std::array<symbolic::Interval, 2>& part, double tolerance);

}  // namespace eliminant::intersect
