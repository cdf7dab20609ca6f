// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::symbolic {

/// The different irreducible factors over Q of a polynomial that is not zero: primitive over Z, none constant.
std::vector<Polynomial> irreducible_factors(const Polynomial& p);

/// Their product, without factoring over Q.
Polynomial squarefree_part(const Polynomial& p);

/// The different irreducible factors over Z of a univariate polynomial.
std::vector<UnivariatePolynomial> irreducible_factors(const UnivariatePolynomial& p);

}  // namespace eliminant::symbolic
