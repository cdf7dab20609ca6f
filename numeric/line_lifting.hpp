// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <optional>

#include <eliminant/numeric/bivariate_polynomial.hpp>
#include <eliminant/numeric/newton_refinement.hpp>

namespace eliminant::numeric {

/// The lines x_weight x + y_weight y = t, x_weight != 0.
struct LinePencil {
  double x_weight = 1;
  double y_weight = 0;
};

/// The common zero of p and q, of total degrees m >= n >= 1, on the line of the value t, where they have one: with x
/// eliminated the restrictions are polynomials in y, and the kernel of their m x m hybrid Bezout matrix, n rows of
/// Cayley's quotient and m - n multiples of q, is spanned by (1, y, ..., y^(m-1)). It comes from one LU factorisation
/// with partial pivoting. nullopt when a pivot before the last vanishes. Guarantee: none (floating point); where two
/// common zeros lie on the line the result is near neither.
std::optional<PlanePoint<double>> common_zero_on_line(const BivariatePolynomial<double>& p,
                                                      const BivariatePolynomial<double>& q, long m, long n,
                                                      const LinePencil& lines, const std::complex<double>& t);

}  // namespace eliminant::numeric
