// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// A control point with its weight multiplied in, in doubles: (w x, w y, w z, w).
using HomogeneousPoint = std::array<double, 4>;
/// The same of rational numbers.
using ExactPoint = std::array<symbolic::Rational, 4>;

/// Control points in rational numbers, on [0, 1] or [0, 1]^2, the last parameter running fastest.
struct ExactNet {
  std::vector<std::size_t> degrees;
  std::vector<ExactPoint> points;
};

/// The control points of a Bezier curve on [0, 1] or of a tensor-product patch on [0, 1]^2 in hardware doubles, moved
/// by a translation, each with a bound of its error.
struct ControlNet {
  /// Degree in each parameter: one for a curve, two for a patch; each at least 1.
  std::vector<std::size_t> degrees;
  /// (w x, w y, w z, w), the last parameter running fastest.
  std::vector<Eigen::Array4d> points;
  /// A bound of the error of each coordinate of all points.
  Eigen::Array4d error = Eigen::Array4d::Zero();
  /// All weights are exactly 1.
  bool polynomial = false;

  std::size_t parameters() const { return degrees.size(); }

  /// Moves the exact points by -origin, divides by their weight if they all have the same one, and rounds. nullopt when
  /// a number is outside the range in which hardware doubles are safe.
  static std::optional<ControlNet> round(std::vector<std::size_t> degrees, const std::vector<ExactPoint>& points,
                                         const std::array<symbolic::Rational, 3>& origin);
  /// The same of points in doubles, which are taken as exact.
  static std::optional<ControlNet> of(std::vector<std::size_t> degrees, const std::vector<HomogeneousPoint>& points,
                                      const std::array<double, 3>& origin);
};

}  // namespace eliminant::bridge
