// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// A curve in the parameters (a, b) of one map, and the parameters that another map has there.
struct ContactRelation {
  /// In (a, b), not constant.
  Polynomial curve{2};
  /// The parameters of the other map are numerator / denominator, in (a, b).
  std::array<Polynomial, 2> numerator{Polynomial(2), Polynomial(2)};
  std::array<Polynomial, 2> denominator{Polynomial(2), Polynomial(2)};
};

/// Whether a polynomial in (a, b) vanishes on the curve: its equation, which must have no multiple factor, divides it.
bool vanishes_along(const Polynomial& p, const Polynomial& curve);

/// Whether both maps have equal points along the curve, wherever the denominators and the weights are not zero: the
/// curve divides the minors that say so. Otherwise as touch_along.
bool meet_along(const std::vector<Polynomial>& first, const std::vector<Polynomial>& second,
                const ContactRelation& relation);

/// Whether both maps have equal points and equal tangent planes along the curve, wherever the denominators and the
/// weights are not zero and the second map is immersed: the curve divides the minors that say so. A proof where true;
/// also false where a denominator vanishes along the curve. The maps are their four homogeneous coordinates, the weight
/// last, polynomials in two variables. Throws InvalidInput where the curve is constant.
bool touch_along(const std::vector<Polynomial>& first, const std::vector<Polynomial>& second,
                 const ContactRelation& relation);

/// Whether both maps have equal points and equal tangent planes at parameters (u, v, s, t) that are the values of these
/// polynomials in the first variable at a root of `minimal`, whichever it is, if the weights are not zero there and the
/// second map is immersed: `minimal`, in the first variable alone, divides the minors that say so. Throws InvalidInput
/// where it is constant.
bool touch_at_roots(const std::vector<Polynomial>& first, const std::vector<Polynomial>& second,
                    const Polynomial& minimal, const std::array<Polynomial, 4>& parameters);

}  // namespace eliminant::symbolic
