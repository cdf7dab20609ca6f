// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/integer.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// A basis of the vectors c over Z with sum c_i p_i = 0, for polynomials in the same variables with integer
/// coefficients.
std::vector<std::vector<Integer>> linear_relations(const std::vector<Polynomial>& p);

/// The sum of c_i p_i.
Polynomial linear_combination(const std::vector<Integer>& c, const std::vector<Polynomial>& p);

/// All monomials of one degree in x, y, z, w.
std::vector<Polynomial> monomials_in_space(unsigned long degree);

}  // namespace eliminant::symbolic
