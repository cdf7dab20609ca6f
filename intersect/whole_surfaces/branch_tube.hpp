// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/intersect/whole_surfaces/surface_charts.hpp>

namespace eliminant::intersect {

/// Which of the parameters u, v, s, t are inverses of themselves here.
using Charts = std::array<bool, 4>;
using ParameterBox = std::array<DoubleInterval, 4>;

/// Parameters (u, v, s, t) in charts, each at most about 1 in modulus.
struct BranchPoint {
  Charts inverted{};
  std::array<double, 4> at{};
};

/// A box that is proven to hold a point of the intersection.
struct PointEnclosure {
  Charts inverted{};
  ParameterBox box;
};

/// The box in charts that fit `inverted`; an entry is everything where a parameter would be infinite.
ParameterBox in_charts(const ParameterBox& box, const Charts& from, const Charts& to);

/// Points of space with weight 1 on a box, the velocity of such a point; everything where the weight may be 0.
using SpaceBox = std::array<DoubleInterval, 3>;

/// Three equations in four unknowns: Phi(u, v) and Psi(s, t) are one point of projective space.
class SurfacePair {
 public:
  SurfacePair(const symbolic::RationalSurface& first, const symbolic::RationalSurface& second)
      : first_(first), second_(second) {}

  /// The values Phi_i Psi_k - Phi_k Psi_i, i != k, and their derivatives; where Phi_k and Psi_k are not 0 they vanish
  /// exactly at common points.
  template <class Number>
  struct EquationsIn {
    std::array<Number, 3> value{};
    std::array<std::array<Number, 4>, 3> jacobian{};
    bool valid = false;  ///< Phi_k and Psi_k are surely not 0
  };
  using Equations = EquationsIn<DoubleInterval>;
  Equations equations(const Charts& inverted, const ParameterBox& box, std::size_t k) const;
  /// Approximately, and much faster.
  EquationsIn<double> approximate_equations(const BranchPoint& point, std::size_t k) const;
  /// The coordinate k that is large in both points.
  std::size_t pivot(const BranchPoint& point) const;
  /// Whether no parameters in the box have a common point.
  bool excludes(const Charts& inverted, const ParameterBox& box) const;

  SpaceBox point(const Charts& inverted, const ParameterBox& box) const;
  /// The same by the second surface.
  SpaceBox second_point(const Charts& inverted, const ParameterBox& box) const;
  /// The velocity of the point for a velocity of the parameters of the first surface.
  SpaceBox velocity(const Charts& inverted, const ParameterBox& box, const ParameterBox& parameters) const;
  const SurfaceCharts& first() const { return first_; }
  const SurfaceCharts& second() const { return second_; }

 private:
  SurfaceCharts first_;
  SurfaceCharts second_;
};

/// A piece of the intersection: for every value of the parameter `axis` within `range` of its centre there is exactly
/// one point of the intersection within `radius` of the line centre + slope * (difference), and these form a smooth
/// arc.
struct BranchTube {
  BranchPoint centre;
  std::size_t axis = 0;
  std::array<double, 4> slope{};
  DoubleInterval range;
  std::array<double, 4> radius{};
  /// Of the arc, and its velocity by the parameter of the axis.
  ParameterBox hull;
  ParameterBox velocity;

  /// Whether the box, in the charts of the centre, lies in the tube.
  bool holds(const ParameterBox& box) const;
};

/// By Krawczyk's operator for the three unknowns, uniformly in the fourth parameter; `centre` is close to a point of
/// the intersection. nullopt when the test fails. `floor` is the least radius. Source: [Krawczyk1969].
std::optional<BranchTube> enclose_branch(const SurfacePair& pair, const BranchPoint& centre, std::size_t axis,
                                         const std::array<double, 4>& slope, const DoubleInterval& range,
                                         double floor = 1e-15);

/// Newton's method with the parameter `axis` fixed: no guarantee. False when it does not converge.
bool approximate_branch_point(const SurfacePair& pair, BranchPoint& point, std::size_t axis);

/// A direction of the intersection of length 1; nullopt where it has no clear one.
std::optional<std::array<double, 4>> branch_direction(const SurfacePair& pair, const BranchPoint& point);

/// The box around `point`, with the parameter `axis` fixed, that holds exactly one point of the intersection.
std::optional<PointEnclosure> enclose_branch_point(const SurfacePair& pair, const BranchPoint& point, std::size_t axis);

}  // namespace eliminant::intersect
