// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include <eliminant/numeric/bivariate_polynomial.hpp>

namespace eliminant::numeric {

template <class Scalar>
struct PlanePoint {
  std::complex<Scalar> x, y;
};

/// Newton's method for p = q = 0 from `start`, at most `max_steps` steps, stopped when a step no longer shrinks or is
/// below the rounding error. The result is the last point that is finite; it need not be near a solution.
template <class Scalar>
PlanePoint<Scalar> newton_refinement(const BivariatePolynomial<Scalar>& p, const BivariatePolynomial<Scalar>& q,
                                     PlanePoint<Scalar> start, int max_steps) {
  using Complex = std::complex<Scalar>;
  Scalar last_step = std::numeric_limits<Scalar>::max();
  for (int step = 0; step < max_steps; ++step) {
    const Jet<Scalar> f = jet(p, start.x, start.y);
    const Jet<Scalar> g = jet(q, start.x, start.y);
    const Complex determinant = f.dx * g.dy - f.dy * g.dx;
    const Complex dx = (f.value * g.dy - f.dy * g.value) / determinant;
    const Complex dy = (f.dx * g.value - f.value * g.dx) / determinant;
    if (!is_finite(dx) || !is_finite(dy)) break;
    const PlanePoint<Scalar> next{start.x - dx, start.y - dy};
    if (!is_finite(next.x) || !is_finite(next.y)) break;
    const Scalar size = std::max({Scalar(1), modulus<Scalar>(next.x), modulus<Scalar>(next.y)});
    const Scalar length = std::max(modulus<Scalar>(dx), modulus<Scalar>(dy)) / size;
    start = next;
    if (length <= Scalar(4) * machine_epsilon<Scalar>()) break;
    if (step > 2 && length >= last_step && length < Scalar(1e-6)) break;
    last_step = length;
  }
  return start;
}

}  // namespace eliminant::numeric
