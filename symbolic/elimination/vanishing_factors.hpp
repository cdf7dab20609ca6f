// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/elimination/univariate_representation.hpp>

namespace eliminant::symbolic {

/// For each class of a representation the factor of its polynomial whose roots belong to the solutions at which q
/// vanishes too: the gcd with q along the class.
std::vector<UnivariatePolynomial> vanishing_factors(const UnivariateRepresentation& representation,
                                                    const Polynomial& q);

}  // namespace eliminant::symbolic
