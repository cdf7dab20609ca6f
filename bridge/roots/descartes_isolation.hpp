// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::bridge {

/// The real roots of a squarefree polynomial over Z, each in a ball of its own, in ascending order: the balls are
/// pairwise disjoint, each contains exactly one real root (non-real ones may be near), and the polynomial has opposite
/// signs at the ends of each; a root that was met exactly has radius 0. nullopt where the roots lie so close together
/// that isolating all complex roots is the better way.
///
/// Proof: Descartes' rule of signs for the Bernstein coefficients on an interval: no change of sign, no root; one
/// change, one root. Coefficients are truncated to 122 bits with a bound on their error, and subdivided by de
/// Casteljau's algorithm; where that leaves the number of changes open they are computed again from the exact
/// polynomial ([RouillierZimmermann2004]), and an interval is divided only where the sign of the polynomial is known
/// ([EigenwilligEtAl2005]).
std::optional<std::vector<RealBall>> descartes_isolation(const symbolic::UnivariatePolynomial& squarefree,
                                                         const Context& context);

/// Makes the radius of a ball of descartes_isolation at most 2^-relative_bits times the root: Newton's method and
/// bisection, each step accepted by the signs at the ends ([Abbott2014], quadratic interval refinement). The root must
/// not be 0.
void refine_real_root(const symbolic::UnivariatePolynomial& squarefree, RealBall& ball, long relative_bits,
                      const Context& context);

}  // namespace eliminant::bridge
