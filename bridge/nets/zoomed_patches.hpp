// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/bridge/branches/arc_tracing.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// Two tensor-product patches, exactly and rounded; equal ones for double points of one patch.
struct PatchPairNets {
  const ControlNet& first;
  const ControlNet& second;
  const ExactNet& exact_first;
  const ExactNet& exact_second;
  /// The point of space at which the coordinates of the rounded nets are zero.
  const std::array<symbolic::Rational, 3>& origin;
};

/// The part of a patch with its parameters from `lower` to `lower` + `width`, also beyond [0, 1], by blossoms.
ExactNet restricted(const ExactNet& net, const std::array<symbolic::Rational, 2>& lower,
                    const symbolic::Rational& width);

/// Both patches around one point of space and a pair of parameters in each, restricted exactly before they are rounded.
///
/// Near a singular point of their intersection the patches differ by far less than their size times the accuracy of
/// doubles; zoomed in, all coordinates are small, and so are their roundings.
class ZoomedPatches {
 public:
  /// The parameters within `half` of `centre`, which is taken exactly; nullopt where numbers become too small for
  /// doubles.
  static std::optional<ZoomedPatches> around(const PatchPairNets& nets, const std::array<symbolic::Rational, 4>& centre,
                                             double half);

  /// Its own nets on [0, 1]^2, the centre at 1/2.
  PatchPairNets nets() const { return {first_, second_, exact_first_, exact_second_, origin_}; }

  std::array<double, 4> zoomed(const std::array<double, 4>& parameters) const;
  /// Back: parameters and point in the coordinates of the original nets.
  TracedPoint original(const TracedPoint& point) const;
  const std::array<symbolic::Rational, 4>& centre() const { return exact_centre_; }
  double half() const { return half_; }

 private:
  ZoomedPatches() = default;

  std::array<symbolic::Rational, 4> exact_centre_;
  std::array<double, 4> centre_{};
  double half_ = 0;
  ExactNet exact_first_;
  ExactNet exact_second_;
  ControlNet first_;
  ControlNet second_;
  std::array<symbolic::Rational, 3> origin_;
  /// From the original origin to that one.
  std::array<double, 3> shift_{};
};

}  // namespace eliminant::bridge
