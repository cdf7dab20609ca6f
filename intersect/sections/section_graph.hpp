// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/enclosures/ball_curve.hpp>
#include <eliminant/intersect/patches/branch_components.hpp>
#include <eliminant/intersect/sections/section_factors.hpp>
#include <eliminant/intersect/sections/section_patch.hpp>
#include <eliminant/intersect/topology/curve_topology.hpp>

namespace eliminant::intersect {

/// A vertex of the topology, as the curve in space sees it.
struct SectionVertex {
  /// Edges of curves that end here.
  std::size_t ends = 0;
  /// The same along a seam, of curves that are found on the other patch.
  std::size_t elsewhere = 0;
  /// On the curve: a factor that is one may vanish here.
  bool on_curve = false;
  /// The weight may vanish here: at infinity, or a base point.
  bool at_infinity = false;
  /// All coordinates may vanish here.
  bool base_point = false;
  /// Curves of parameters that are mapped to one point each: index of their group.
  std::optional<std::size_t> group;
  /// Of u and v: -1 on the lower border of the domain, 1 on the upper one.
  std::array<int, 2> side{};
  /// A smooth point inside a branch.
  bool passes = false;
};

struct SectionEdge {
  std::size_t factor = 0;
  /// Sign of the weight on it.
  int weight_sign = 1;
  /// Within the radius of this point it is the only arc: there the derivative of the factor by v, of a part of a line
  /// u = constant that by u, is not zero.
  std::array<double, 2> sample{};
  double radius = 0;
  bool vertical = false;
};

/// The topology of the curve in the parameters, every edge with the factor that vanishes on it.
class SectionGraph {
 public:
  /// `factors` are irreducible, different, those of the weight among them unless that has one sign.
  SectionGraph(const symbolic::SurfacePiece& patch, std::vector<SectionFactor> factors, bool weight_has_one_sign,
               const SideRoles& roles, const Options& options, const Context& context);

  const std::vector<SectionFactor>& factors() const { return factors_; }
  const TopologyResult& topology() const { return topology_; }
  const std::vector<SectionVertex>& vertices() const { return vertices_; }
  /// Of the edges of the topology that are parts of the curve.
  const std::vector<std::optional<SectionEdge>>& edges() const { return edges_; }
  /// Every branch with its edges as arcs; start and end are vertices.
  std::vector<BranchChain> chains() const;
  /// One vertex of every group.
  const std::vector<std::vector<std::size_t>>& groups() const { return groups_; }
  /// Nothing that was found is unclear.
  bool complete() const { return complete_; }
  /// Whether both partial derivatives of a factor may vanish at a vertex.
  bool is_singular_for(std::size_t factor, std::size_t vertex) const;
  /// Whether points of the surface go to infinity along a factor at a base point: because they do so along every path
  /// there (symbolic/elimination/infinite_base_points), or the factor is smooth and the weight vanishes to a higher
  /// order along it than another coordinate. False also where that is not proven.
  bool goes_to_infinity(std::size_t factor, std::size_t base_point, const Options& options,
                        const Context& context) const;

 private:
  bridge::PlaneBall place_of(const TopologyVertex& vertex) const;
  bool may_vanish(const bridge::BallCurve& curve, const bridge::PlaneBall& at) const;
  /// Whether the vertex, where the factor meets the weight, has both parameters 0.
  bool is_origin(std::size_t factor, std::size_t vertex) const;
  std::optional<SectionEdge> identified(const TopologyEdge& edge) const;
  std::optional<SectionEdge> identified_at(const std::array<double, 2>& point, bool vertical) const;
  void describe_edges(const SideRoles& roles);
  void describe_vertices(const symbolic::SurfacePiece& patch, bool weight_has_one_sign);
  /// Order of vanishing of a coordinate along a factor at a vertex: an intersection multiplicity.
  std::optional<unsigned long> order_along(std::size_t factor, std::size_t coordinate, std::size_t vertex,
                                           const Options& options, const Context& context) const;
  void gather_groups(const std::vector<std::size_t>& point_edges);
  bool is_on_other_seam(const TopologyEdge& edge, const SideRoles& roles) const;

  std::vector<SectionFactor> factors_;
  std::vector<bridge::BallCurve> balls_;
  std::vector<symbolic::Polynomial> polynomials_;
  std::vector<bridge::BallCurve> coordinates_;
  std::array<symbolic::Interval, 2> domain_;
  TopologyResult topology_;
  bool infinite_around_origin_ = false;
  std::vector<SectionVertex> vertices_;
  std::vector<std::optional<SectionEdge>> edges_;
  std::vector<std::vector<std::size_t>> groups_;
  bool complete_ = true;
};

}  // namespace eliminant::intersect
