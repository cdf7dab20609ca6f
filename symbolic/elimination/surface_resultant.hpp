// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>

namespace eliminant::symbolic {

/// S^k(Psi(t)) of a tensor-product surface without base points, S its implicit equation and k the degree of its map:
/// the resultant of three planes through Psi(t), restricted to the surface, up to a constant. As det M(Psi(t)) with the
/// square matrix of moving planes, but from kernels modulo primes, whose entries stay small: rational reconstruction,
/// and as many primes as a bound of the resultant ([Sombra2004]) asks for before the result is believed. nullopt when
/// the matrix is not square or a resultant vanishes: the surface has base points, or the curve lies in it.
std::optional<ParameterForm> surface_resultant_on_curve(const RationalSurface& surface, const RationalCurve& curve,
                                                        std::uint64_t seed, const Context& context);

}  // namespace eliminant::symbolic
