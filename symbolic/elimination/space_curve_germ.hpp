// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// The projection along x_index of the curve f = g = 0 in (x, y, z), with its components simple: squarefree, free of
/// x_index, zero exactly where a common zero of f and g lies above, complex ones included. nullopt where f or g does
/// not have as large a degree in x_index as in all variables together, or both have a factor in common.
std::optional<Polynomial> projected_curve(const Polynomial& f, const Polynomial& g, std::size_t index);

/// Whether the curve f = g = 0 in (x, y, z), with its components simple and over the complex numbers, is proven to be
/// singular in the origin. `projections` are those of projected_curve. Method: were it smooth there, its projections
/// along all axes but one at most would be smooth, too, where no other common zero lies on the axis.
bool is_singular_at_origin(const Polynomial& f, const Polynomial& g,
                           const std::array<std::optional<Polynomial>, 3>& projections);

}  // namespace eliminant::symbolic
