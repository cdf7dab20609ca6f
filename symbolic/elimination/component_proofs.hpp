// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/separated_bezoutian.hpp>

namespace eliminant::symbolic {

/// Proofs about the common points above a component f = 0 of the determinant's curve, f irreducible over Q, from the
/// kernel of the matrix modulo f: where the rank falls by one only, the kernel is spanned by the vector of all s^i v^j
/// of the one pair of parameters there, and cofactors of one row are a multiple of it. False where nothing is proven,
/// also where the rank falls by more.

/// All common points above f = 0 have weight zero.
bool proves_weight_zero(const SeparatedBezoutian& matrix, const RationalSurface& first, const RationalSurface& second,
                        const Polynomial& f, std::uint64_t seed, const Context& context);

/// f depends on one variable only, and the common points above each line of f = 0 are one point of space: one surface
/// contracts a curve of parameters to it.
bool proves_one_point(const SeparatedBezoutian& matrix, const Polynomial& f, std::uint64_t seed,
                      const Context& context);

/// f, in one variable, divides the weight of the surface whose parameter it is: that curve of the surface is at
/// infinity.
bool divides_weight(const RationalSurface& surface, const Polynomial& f);

}  // namespace eliminant::symbolic
