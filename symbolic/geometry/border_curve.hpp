// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// The curve of a tensor-product surface on which parameter `axis` (0 or 1) is `value`, nullopt meaning infinity; of a
/// triangular surface that on which the homogeneous parameter `axis` (0, 1 or 2) is 0. In the other parameter, or in
/// the ratio of the two others. nullopt when all coordinates vanish there: a line of base points.
/// Throws InvalidInput for a triangular surface and another value than 0.
std::optional<RationalCurve> border_curve(const RationalSurface& surface, std::size_t axis,
                                          const std::optional<Rational>& value);

}  // namespace eliminant::symbolic
