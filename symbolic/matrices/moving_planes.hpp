// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::symbolic {

/// M(f)_nu of a surface over the projective plane: rows belong to the monomials s^i t^j u^k of degree nu, columns to a
/// basis of the moving planes of degree nu. For nu >= representation_degree(surface) and base points that are locally
/// complete intersections it represents the surface to the power of the degree of the map.
/// Source: [LuuBuseMourrain2009], section 2.2 and Proposition 2. Throws InvalidInput when the surface is of the other
/// kind or nu is negative.
MatrixRepresentation moving_plane_matrix(const RationalSurface& surface, long nu);

/// The same over the product of two projective lines: rows belong to s^i t^j, i <= nu[0], j <= nu[1].
/// Source: [BuseDohm2007].
MatrixRepresentation moving_plane_matrix(const RationalSurface& surface, std::array<long, 2> nu);

/// The linear system of the moving planes of degree nu over the product of two projective lines: its kernel holds their
/// coefficients, that of row i of the matrix in the form x_k at position k rows + i.
IntegerMatrix moving_plane_system(const RationalSurface& surface, std::array<long, 2> nu);

/// max(d - 1, 2 (d - 1) - k) with k the least degree of a form in the saturation of the base ideal (0 without base
/// points), for a surface over the projective plane. The saturation is computed modulo a prime of `seed`.
long representation_degree(const RationalSurface& surface, std::uint64_t seed = 0);

/// (2 m - 1, n - 1) or (m - 1, 2 n - 1), for a tensor-product surface of bidegree (m, n): the one whose row monomials
/// tell both parameters apart, where there is a choice.
std::array<long, 2> representation_bidegree(const RationalSurface& surface);

/// The matrix of the degree that the two functions above say.
MatrixRepresentation matrix_representation(const RationalSurface& surface);

}  // namespace eliminant::symbolic
