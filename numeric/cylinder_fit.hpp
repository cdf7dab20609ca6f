// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include <eliminant/numeric/cylinder_through_points.hpp>
#include <eliminant/numeric/point_grid.hpp>

namespace eliminant::numeric {

/// Where a point is as seen from a cylinder.
struct CylinderCoordinates {
  /// Along the axis, from the foot of the axis point.
  double height = 0;
  /// Distance from the surface, negative inside.
  double residual = 0;
};

/// Distances from one cylinder, whose direction need not have length 1.
class CylinderFrame {
 public:
  explicit CylinderFrame(const Cylinder& cylinder);

  CylinderCoordinates at(const Point& point) const;
  /// The angle around the axis, in (-pi, pi], from a direction that the frame chooses.
  double angle(const Point& point) const;
  /// The point of the axis at this height.
  Point axis_at(double height) const;

 private:
  Cylinder cylinder_;
  Point u_{};
  Point v_{};
};

/// The cylinder that minimizes the sum of the squared distances of at least five points from it, near `start`; `start`
/// itself when the iteration comes to nothing finite. The axis point becomes the foot of the points' mean, the
/// direction has length 1.
/// Source: Levenberg-Marquardt iteration for direction, axis and radius, five numbers in the frame of `start`.
/// Guarantee: none (floating point, a local minimum).
Cylinder fit_cylinder(std::span<const Point> points, const Cylinder& start);

/// Root of the mean of the squared distances; 0 without points.
double rms_distance(std::span<const Point> points, const Cylinder& cylinder);

}  // namespace eliminant::numeric
