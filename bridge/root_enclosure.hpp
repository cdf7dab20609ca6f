// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/ball.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::bridge {

/// One ball around each complex root of a squarefree polynomial of degree >= 1, pairwise disjoint, each with exactly
/// one root. Real roots have imaginary part exactly 0, and a root with non-zero imaginary part is not real. The root 0
/// is exact. The radius of every part is at most 2^-relative_bits times the modulus of the root. `approximations`
/// (possibly empty, possibly wrong) are starting values for the simultaneous iteration. The result is proven whatever
/// the starting values. Sorted by real part, then imaginary part.
std::vector<ComplexBall> enclose_roots(const symbolic::UnivariatePolynomial& squarefree,
                                       const std::vector<ComplexBall>& approximations, long relative_bits,
                                       const Context& context);

}  // namespace eliminant::bridge
