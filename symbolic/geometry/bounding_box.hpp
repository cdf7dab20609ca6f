// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// A closed box with axis-parallel sides in the affine plane or in affine space: an interval for each coordinate.
using BoundingBox = std::vector<Interval>;

/// The smallest box around the control points of a curve on its domain, which contains the curve there: the Bernstein
/// coefficients of its coordinates divided by those of the weight, all exact. nullopt without a domain, and where the
/// coefficients of the weight are not all positive or all negative: then a point of the curve may be anywhere.
std::optional<BoundingBox> bounding_box(const CurvePiece& piece);

/// The same of a patch on its region, a rectangle or the triangle.
std::optional<BoundingBox> bounding_box(const SurfacePiece& piece);

/// Whether two boxes of one dimension have no common point.
bool are_disjoint(const BoundingBox& a, const BoundingBox& b);

}  // namespace eliminant::symbolic
