// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/bridge/nets/zoomed_patches.hpp>
#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/intersect/overlaps/border_arc.hpp>
#include <eliminant/intersect/patches/contact_arcs.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// Two patches with balanced weights, exactly and in doubles with one origin, and the way back from the parameters of
/// their nets, (u, v, s, t) in [0, 1]^4, to those of the surfaces.
class BalancedPair {
 public:
  BalancedPair(PreparedNet first, PreparedNet second);

  /// Why the patches cannot be taken; empty where they can. Everything below asks for that.
  const std::string& obstacle() const { return obstacle_; }

  bridge::PatchPairNets nets() const { return {first_net_, second_net_, first_.exact, second_.exact, origin_}; }
  /// Of the smaller patch.
  double size() const;

  double to_domain(std::size_t k, double local) const;
  SurfacePoint placed(const std::array<double, 4>& parameters, const std::array<double, 3>& point) const;
  /// The point of the first patch.
  SurfacePoint placed(const std::array<double, 4>& parameters) const;
  /// Without ends; `error` includes the rounding of the translation.
  SurfaceComponent placed(SurfaceComponentKind kind, const DrawnCurve& drawn) const;
  /// An arc of a curve that is known by its equation: not said to be certified, ends on borders.
  SurfaceComponent placed(const ContactArc& arc) const;
  /// Newton's method has moved the end of a polyline off the border a little.
  void put_on_border(SurfacePoint& point, const BranchEnd& end) const;

  /// What the sum with the origin and its rounding add to the error of a polyline.
  double rounding_of(const SurfaceComponent& component) const;
  /// How far the point of the first patch at the parameters given is from the true one.
  double error_in_space(const bridge::CrossingPoint& point) const;
  /// Whether the tangent planes are equal, or differ by so little that doubles cannot tell.
  bool is_tangential(const std::array<double, 4>& parameters) const;
  /// How the border curve of the first side that is not 0 crosses the other surface.
  Transition transition_at(const std::array<double, 4>& parameters, const std::array<int, 4>& side) const;

 private:
  PreparedNet first_;
  PreparedNet second_;
  std::string obstacle_;
  std::array<symbolic::Rational, 3> origin_;
  std::array<double, 3> rounded_origin_{};
  /// Of u, v, s, t.
  std::array<std::array<double, 2>, 4> bounds_{};
  /// Of u, v, s, t: parameters of the nets are those of the patches with u / (1 - u) divided by that.
  std::array<double, 4> balance_{1, 1, 1, 1};
  bridge::ControlNet first_net_;
  bridge::ControlNet second_net_;
};

}  // namespace eliminant::intersect
