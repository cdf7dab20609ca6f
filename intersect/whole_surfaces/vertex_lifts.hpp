// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/intersect/whole_surfaces/parameter_fibre.hpp>
#include <eliminant/symbolic/matrices/separated_bezoutian.hpp>

namespace eliminant::intersect {

/// What lies above a singular point of the projection.
enum class VertexLift {
  one_point,  ///< one common point only, complex ones included: all branches meet there
  branches,   ///< common points through which smooth branches pass, or none
  complex,    ///< no real common point
  undecided
};

/// The parameters above singular points of the eliminant's curve, by the rank of the Bezoutian matrix and subdivision.
class VertexLifts {
 public:
  /// Of two surfaces, or of one with itself, the matrix in the parameters of the projection; all must outlive the
  /// object.
  VertexLifts(const SurfacePair& pair, const symbolic::SeparatedBezoutian& matrix, bool with_itself)
      : pair_(pair), matrix_(matrix), with_itself_(with_itself) {}

  struct Found {
    VertexLift lift = VertexLift::undecided;
    /// Encloses the point.
    std::optional<FibreBox> box;
  };
  /// `kept` encloses the parameters u and t of the surfaces at the vertex, in these charts.
  Found above(const TopologyVertex& vertex, const std::array<bool, 2>& inverted,
              const std::array<DoubleInterval, 2>& kept) const;

 private:
  bool has_corank_one(const TopologyVertex& vertex) const;

  const SurfacePair& pair_;
  const symbolic::SeparatedBezoutian& matrix_;
  bool with_itself_;
};

}  // namespace eliminant::intersect
