// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// Whether the four coordinates of a tensor-product surface have a common zero, also at infinity of the other
/// parameter, where parameter `index` is a root of f, irreducible over Z. A proof either way: one coordinate, brought
/// to full degree by a change of the other parameter, and a combination of the others in which each has its own power
/// of x have a resultant that vanishes modulo f for so many values of x that it vanishes for all. Throws InvalidInput
/// for a surface of triangular kind.
bool has_base_point_above(const RationalSurface& surface, std::size_t index, const UnivariatePolynomial& f,
                          const Context& context);

}  // namespace eliminant::symbolic
