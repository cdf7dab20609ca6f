// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/intersect/cylinders/cylinders.hpp>

namespace eliminant::intersect {

using BallVector = std::array<bridge::ComplexBall, 3>;

/// a.b without conjugation.
bridge::ComplexBall dot_product(const BallVector& a, const BallVector& b, long precision_bits);
BallVector cross_product(const BallVector& a, const BallVector& b, long precision_bits);

/// Enclosures of a cylinder, normalised as CylinderSolution says.
struct CylinderBalls {
  BallVector direction;
  BallVector axis_point;
  bridge::ComplexBall radius_squared;
};

/// The cylinder through the five points with this direction; `real` says that the direction is. nullopt where the balls
/// are too wide for it, as they always are where t.t = 0.
std::optional<CylinderBalls> cylinder_of_direction(const std::array<symbolic::SpacePoint, 5>& points,
                                                   const BallVector& direction, bool real, long precision_bits);

/// The residual of printed numbers with t.t = 0: more digits are needed to show what the cylinder is.
inline constexpr long unbounded_residual = std::numeric_limits<long>::max();

/// Rounds the balls to `digits` digits: of the largest coordinate of the direction, of the larger of axis point and
/// points, and of the radius. nullopt where they are too wide for that.
std::optional<CylinderSolution> print_cylinder(const std::array<symbolic::SpacePoint, 5>& points,
                                               const CylinderBalls& cylinder, bool real, long digits,
                                               long precision_bits);

}  // namespace eliminant::intersect
