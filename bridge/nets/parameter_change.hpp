// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// x -> (a x + b) / (c x + d) on the projective line over Q, a d - b c not zero.
struct ProjectiveMap {
  symbolic::Rational a = 1;
  symbolic::Rational b;
  symbolic::Rational c;
  symbolic::Rational d = 1;

  /// nullopt where the value is infinite.
  std::optional<symbolic::Rational> at(const symbolic::Rational& x) const;
  ProjectiveMap inverse() const { return {d, -b, -c, a}; }
  /// The one that takes three different numbers to three different numbers; nullopt where two are equal.
  static std::optional<ProjectiveMap> through(const std::array<symbolic::Rational, 3>& from,
                                              const std::array<symbolic::Rational, 3>& to);
};

/// From the parameters of one patch to those of another, each by a projective map of its own.
struct ParameterChange {
  /// The first parameter of the second patch depends on the second one of the first.
  bool exchanged = false;
  /// From the first parameter of the first patch, and from the second.
  std::array<ProjectiveMap, 2> maps;

  /// Of the second patch's parameter that the parameter `axis` of the first patch becomes.
  std::size_t image_axis(std::size_t axis) const { return exchanged ? 1 - axis : axis; }
};

/// The patch with its parameter `axis` replaced by the map: control points on [0, 1]^2 again, by blossoming. Weights
/// may become negative.
ExactNet composed(const ExactNet& net, std::size_t axis, const ProjectiveMap& map);

/// Whether second(change(u, v)) and first(u, v) are one map, exactly.
bool is_same_map(const ExactNet& first, const ExactNet& second, const ParameterChange& change);

/// A change of parameters that makes both patches parts of one map. From a common point near parameters given in
/// doubles Newton's method in long numbers finds those of four more points, which are rational if there is such a
/// change; that it is one is proven by is_same_map. nullopt when there is none, or none was recognised: degrees differ,
/// the starting point is none, numbers are long.
std::optional<ParameterChange> parameter_change(const ExactNet& first, const ExactNet& second,
                                                const std::array<double, 4>& start);

}  // namespace eliminant::bridge
