// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace eliminant::intersect {

/// For each of u, v, s, t the bounds of the whole domain; nullopt where the parameter runs over the projective line.
using DomainBounds = std::array<std::optional<std::array<double, 2>>, 4>;

/// Distances of pairs of parameters (u, v, s, t): those with a domain relative to its width.
class ParameterMetric {
 public:
  /// The bounds must outlive the object.
  explicit ParameterMetric(const DomainBounds& bounds);

  /// The largest of the four.
  double distance(const std::array<double, 4>& a, const std::array<double, 4>& b) const;
  /// Up to that distance two pairs are one: ends of curves are refined to much better.
  double same() const { return same_within + rounding_; }
  /// Different ones must be farther apart than that.
  double apart() const { return apart_by + 100 * rounding_; }

 private:
  static constexpr double same_within = 1e-9;
  static constexpr double apart_by = 1e-7;

  double width(std::size_t k) const { return (*bounds_[k])[1] - (*bounds_[k])[0]; }

  const DomainBounds& bounds_;
  /// How far apart doubles make parameters that are the same, relative to the domain.
  double rounding_ = 0;
};

}  // namespace eliminant::intersect
