// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// A quadrilateral between a corner of a triangle, points on both sides next to it, and a point inside, as the
/// projective image of [0, 1]^2 with positive orientation: rational points are images of rational ones, lines of lines.
/// Where the first parameter is 0 it runs along the side to the corner before, where the second is 0 along the side to
/// the corner after; the other two sides are inside the triangle.
struct TriangleCorner {
  /// Of the three corners (1, 0, 0), (0, 1, 0), (0, 0, 1).
  std::size_t corner = 0;
  /// Homogeneous barycentric coordinates of the images of (0, 0), (1, 0), (1, 1) and (0, 1), between which the map is
  /// bilinear, and even linear.
  std::array<std::array<double, 3>, 4> places{};

  /// The first two barycentric coordinates, of sum 1, of a point of the quadrilateral.
  std::array<double, 2> at(double a, double b) const;
  /// Which barycentric coordinate is zero where parameter `axis` of the quadrilateral is 0.
  std::size_t border(std::size_t axis) const { return axis == 0 ? (corner + 1) % 3 : (corner + 2) % 3; }
  /// Whether that border, followed by its own parameter, is followed by the other one of the quadrilateral, too.
  bool follows_border(std::size_t axis) const;
};

struct TriangleChart {
  symbolic::SurfacePiece piece;
  TriangleCorner corner;
};

/// A triangular patch as three tensor-product patches on [0, 1]^2, exactly, of total degree d in both parameters. None
/// has a degenerate corner that the triangle has not. All sides are halved; `which` (0 to 2) says where the parts
/// meet inside: of two surfaces at different places, and on no symmetry, so that curves do not pass through the corner.
std::vector<TriangleChart> triangle_charts(const symbolic::SurfacePiece& triangle, std::size_t which);

/// From the parameters of a quadrilateral of surface `index` (0: u, v; 1: s, t) to those of its triangle.
void to_triangle_parameters(SurfaceResult& result, const TriangleCorner& corner, std::size_t index);

}  // namespace eliminant::intersect
