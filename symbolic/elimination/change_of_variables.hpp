// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// p(t - s y, y): the shear under which t = x + s y becomes the first coordinate.
Polynomial shear(const Polynomial& p, const Rational& s);

/// p(2^a x, 2^b y), exactly.
Polynomial scale_by_powers_of_two(const Polynomial& p, long a, long b);

/// p(y, x).
Polynomial exchange_variables(const Polynomial& p);

}  // namespace eliminant::symbolic
