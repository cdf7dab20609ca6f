// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

/// The points (i_1, ..., i_m) of the simplex i_1 + ... + i_m <= degree, in lexicographic order: the exponents of the
/// monomials of that degree and below, and as many points that determine a polynomial of that degree.
std::vector<std::vector<unsigned long>> simplex_lattice(std::size_t dimension, unsigned long degree);

/// The coefficients, in the order of simplex_lattice, of the polynomial of total degree at most `degree` whose value at
/// origin + point is `values`, in the same order. The characteristic must exceed the degree.
/// By Newton's divided differences, one variable after the other.
std::vector<mp_limb_t> interpolate_on_simplex(const PrimeField& field, const std::vector<mp_limb_t>& origin,
                                              unsigned long degree, const std::vector<mp_limb_t>& values);

}  // namespace eliminant::symbolic
