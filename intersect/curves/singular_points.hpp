// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::intersect {

/// Adds the singular points of the plane curve f = 0, f in Q[x, y], at infinity too, to a result: the common zeros of
/// f_x and f_y, whose intersection multiplicity there is the Milnor number, at which, exactly, f vanishes. Factors of f
/// count once; a repeated one is an overlap. The kind is known for the Milnor numbers 1 (by the sign of the Hessian
/// determinant) and 2 (a cusp). Throws InvalidInput when f is constant.
void add_singular_points(const symbolic::Polynomial& f, const Options& options, const Context& context,
                         CurveResult& result);

}  // namespace eliminant::intersect
