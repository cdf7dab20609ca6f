// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <eliminant/symbolic/elimination/chow_form.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::symbolic {

/// All affine solutions of two coprime curves through the roots of univariate polynomials: the solutions of
/// multiplicity k correspond one to one to the roots t of `factor` of the class with multiplicity k, and there
///     y = -numerator(t) / (k denominator(t)),     x = t - shear * y.
/// With C the Chow form, R its squarefree part and C = c G R, G primitive: numerator = C_s / G, denominator = c R'.
/// This is a rational univariate representation in the sense of [Rouillier1999], read off the Chow form.
struct UnivariateRepresentation {
  long shear = 0;
  std::vector<SquarefreeFactor> classes;
  UnivariatePolynomial numerator;
  UnivariatePolynomial denominator;

  unsigned long with_multiplicity() const;
  unsigned long distinct() const;
};

/// Builds the representation for this shear and proves it: nullopt when two solutions share a value of x + shear y, or
/// when that could not be excluded. The proof, for each class with k >= 2 (a simple root of C has a simple fibre):
/// with e the sum over its fibres of the order to which y - y(t) divides both restrictions, found exactly over Q, and u
/// the upper bound of fibre_gcd_degree_modulo, e = u leaves no room for a second solution on a fibre.
/// p and q are primitive over Z, coprime, not both constant; the shear is admissible.
std::optional<UnivariateRepresentation> univariate_representation(const Polynomial& p, const Polynomial& q, long shear,
                                                                  std::uint64_t seed, const Context& context);

}  // namespace eliminant::symbolic
