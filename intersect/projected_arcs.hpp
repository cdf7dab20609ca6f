// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/branch_tracing.hpp>
#include <eliminant/intersect/curve_topology.hpp>
#include <eliminant/intersect/parameter_fibre.hpp>
#include <eliminant/symbolic/elimination/curve_events.hpp>

namespace eliminant::intersect {

/// An arc of the projection: the graph of a function over an open interval, or a part of a vertical line.
struct ProjectedArc {
  /// Indices of vertices of the topology, by increasing abscissa, of a vertical line by increasing ordinate.
  std::array<std::size_t, 2> ends{};
  bool vertical = false;
  /// Numbers that are surely between the ends: of u, of a vertical line of t.
  DoubleInterval inside;
};

/// The certified topology of the projection D(u, t) = 0, and points above its arcs.
class ProjectedArcs {
 public:
  /// `curve` is not constant. Throws as curve_topology does.
  ProjectedArcs(const symbolic::Polynomial& curve, const Options& options, const Context& context);

  const TopologyResult& topology() const { return topology_; }
  const std::vector<ProjectedArc>& arcs() const { return arcs_; }
  /// A point of the intersection above an interior point of an arc, of which the surfaces have one; nullopt where none
  /// was proven. `share` in (0, 1) says where on the arc.
  std::optional<BranchSeed> seed_above(const SurfacePair& pair, std::size_t arc, double share,
                                       const Context& context) const;
  /// Enclosures of the parameters u and t of a vertex that is not at infinity.
  std::array<DoubleInterval, 2> enclosure(std::size_t vertex) const;

 private:
  /// The other parameter on the arc where its own is `value`, isolated from other points of the projection.
  std::optional<std::array<DoubleInterval, 2>> isolated_root(std::size_t arc, const symbolic::Rational& value,
                                                             double near,
                                                             const Context& context) const;

  TopologyResult topology_;
  std::array<symbolic::HiddenVariablePolynomial, 2> hidden_;
  std::vector<ProjectedArc> arcs_;
};

}  // namespace eliminant::intersect
