// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

/// The sum over the roots t_0 of h of the degree of gcd(f(t_0, y), g(t_0, y)) in y, for a squarefree h in Z[t], seen
/// modulo a prime: an upper bound of the sum over the complex roots. nullopt when the prime is unlucky: h loses its
/// degree or is no longer squarefree, or f or g vanishes on a whole fibre.
///
/// Euclid's algorithm over F[t]/(h), splitting h when a leading coefficient is a zero divisor (dynamic evaluation,
/// [DellaDoraDicrescenzoDuval1985]). A gcd can only grow when it is reduced modulo a prime, hence the inequality.
std::optional<unsigned long> fibre_gcd_degree_modulo(const HiddenVariablePolynomial& f,
                                                     const HiddenVariablePolynomial& g, const UnivariatePolynomial& h,
                                                     const PrimeField& field);

}  // namespace eliminant::symbolic
