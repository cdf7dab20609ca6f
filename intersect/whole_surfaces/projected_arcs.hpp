// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/intersect/whole_surfaces/parameter_fibre.hpp>
#include <eliminant/intersect/whole_surfaces/projection_charts.hpp>
#include <eliminant/intersect/whole_surfaces/tube_tracing.hpp>
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
  /// `curve` is not constant; `changes` give u and t of the surfaces for those of the projection. Throws as
  /// curve_topology does.
  /// Points of the intersection may also lie above `extraneous` = 0, no zero polynomial; seeds never do.
  ProjectedArcs(const symbolic::Polynomial& curve, const symbolic::Polynomial& extraneous,
                const std::array<ProjectiveChange, 2>& changes, const Options& options, const Context& context);

  const TopologyResult& topology() const { return topology_; }
  const std::vector<ProjectedArc>& arcs() const { return arcs_; }
  /// A parameter inside an arc, at this share of its polyline: of u, on a vertical line of t.
  double parameter_at(std::size_t arc, double share) const;
  /// Parameters on an arc beyond `parameter`, in the direction of its end 0 or 1, nearest first.
  std::vector<double> parameters_beyond(std::size_t arc, double parameter, std::size_t end) const;
  /// A point of the intersection above an arc, of which the surfaces have one; nullopt where none was proven.
  std::optional<BranchSeed> seed_above(const SurfacePair& pair, std::size_t arc, double parameter,
                                       const Context& context) const;
  /// The arc, no part of a vertical line, below a point of the intersection; nullopt where that is not clear.
  std::optional<std::size_t> arc_below(const SurfacePair& pair, const PointEnclosure& point,
                                       const Context& context) const;
  /// The parameters of the projection of a point.
  std::array<DoubleInterval, 2> projection(const PointEnclosure& point) const;
  /// All of the arc between the abscissae of two of its points lies in the box of both that is returned: the curve does
  /// not meet the horizontal sides. nullopt when that is not proven.
  std::optional<std::array<DoubleInterval, 2>> box_between(std::size_t arc, const std::array<DoubleInterval, 2>& from,
                                                           const std::array<DoubleInterval, 2>& to,
                                                           const Context& context) const;
  /// From a chart of the surfaces' u (0) or t (1) to the parameter of the projection.
  ProjectiveChange from_chart(std::size_t kept, bool inverted) const {
    return changes_[kept].inverse().after(chart(inverted));
  }
  /// Enclosures of the parameters u and t, in the projection, of a vertex that is not at infinity.
  std::array<DoubleInterval, 2> enclosure(std::size_t vertex) const;

 private:
  /// The arcs above and below each other at an abscissa, ascending.
  std::vector<std::size_t> arcs_at(double x) const;
  /// The real roots on a line u or t = constant, ascending.
  static std::vector<DoubleInterval> roots_at(const symbolic::HiddenVariablePolynomial& polynomial,
                                              const symbolic::Rational& value, const Context& context);
  /// Which of the roots on its line belongs to the arc.
  std::optional<std::size_t> root_of(std::size_t arc, double parameter, const std::vector<DoubleInterval>& roots) const;

  TopologyResult topology_;
  std::array<ProjectiveChange, 2> changes_;
  std::array<symbolic::HiddenVariablePolynomial, 2> hidden_;
  std::array<symbolic::HiddenVariablePolynomial, 2> extraneous_;
  std::vector<ProjectedArc> arcs_;
};

}  // namespace eliminant::intersect
