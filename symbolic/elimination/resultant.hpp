// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

/// det S, the determinant of the Sylvester matrix of f and g, in Z[h] (Definition 1 of [BuseKhalilMourrain2005]; it is
/// (-1)^(deg f deg g) times the resultant in the usual sign). By evaluation, Euclid's algorithm, interpolation and
/// Chinese remaindering up to Hadamard's bound. Throws InvalidInput when f or g is zero.
UnivariatePolynomial resultant(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g,
                               std::uint64_t seed = 0, const Context& context = Context());

/// The same modulo one prime; nullopt when the leading coefficient of f vanishes modulo it.
std::optional<ModularPolynomial> resultant_modulo(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g,
                                                  const PrimeField& field);

}  // namespace eliminant::symbolic
