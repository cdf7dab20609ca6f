// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// Whether F(f_1, ..., f_n) is the zero polynomial, F a form in as many variables as the map has coordinates. A proof
/// either way: F(f) is evaluated modulo primes at as many points as determine it, until the product of the primes
/// exceeds a bound of its coefficients. Throws InvalidInput when F is no form or the number of variables is another.
bool vanishes_on(const Polynomial& form, const RationalCurve& curve, const Context& context);
bool vanishes_on(const Polynomial& form, const RationalSurface& surface, const Context& context);

}  // namespace eliminant::symbolic
