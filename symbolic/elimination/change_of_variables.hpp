// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// p(t - s y, y): the shear under which t = x + s y becomes the first coordinate.
Polynomial shear(const Polynomial& p, const Rational& s);

/// p(2^a x, 2^b y), exactly.
Polynomial scale_by_powers_of_two(const Polynomial& p, long a, long b);

/// p(y, x).
Polynomial exchange_variables(const Polynomial& p);

/// The homogenised p in the projective coordinates (x : y : z) = A (u : v : 1), rows of A first: a polynomial in u, v.
/// A is invertible for the images of two curves to have the same intersections, those at infinity among them.
Polynomial projective_image(const Polynomial& p, const std::array<std::array<long, 3>, 3>& a);

}  // namespace eliminant::symbolic
