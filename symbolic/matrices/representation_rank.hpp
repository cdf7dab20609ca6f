// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::symbolic {

/// M(P) times a positive integer: the homogeneous coordinates of P are multiplied by their common denominator.
/// Throws InvalidInput when P has another number of coordinates than M has variables.
IntegerMatrix value_at(const MatrixRepresentation& m, const std::vector<Rational>& point);

/// The rank of M modulo a prime at a random point of space: that of M over Q(x), or less in rare cases.
long generic_rank_modulo(const MatrixRepresentation& m, std::uint64_t seed);

/// The rank of M modulo a prime at the point of random parameters. The number of rows minus it is, for an admissible
/// degree, the number of parameters of a general point of the surface: the degree of the map ([LuuBuseMourrain2009]).
long rank_on_modulo(const MatrixRepresentation& m, const RationalSurface& surface, std::uint64_t seed);
long rank_on_modulo(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed);

}  // namespace eliminant::symbolic
