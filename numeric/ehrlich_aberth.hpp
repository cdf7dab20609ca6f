// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <vector>

namespace eliminant::numeric {

/// mantissa * 2^exponent, for numbers beyond the range of double. The mantissa is 0 or of modulus in [1/2, 1).
struct ScaledReal {
  double mantissa = 0;
  long exponent = 0;
};

/// mantissa * 2^exponent; the larger part of the mantissa is 0 or of modulus in [1/2, 1).
struct ScaledComplex {
  std::complex<double> mantissa;
  long exponent = 0;
};

ScaledComplex normalized(std::complex<double> mantissa, long exponent);

/// log2 of the radii of the roots of a polynomial as its Newton polygon sees them: the upper convex hull of the points
/// (i, log2 |a_i|) has an edge of slope -r over k steps for k roots of modulus about 2^r. `log2_coefficients` are
/// ascending, -infinity for 0, the first and the last finite; the result is ascending, one entry for each root.
/// Source: [Bini1996].
std::vector<double> newton_polygon_radii(const std::vector<double>& log2_coefficients);

/// Starting values on the circles of these radii (log2), none of them real and no two conjugate.
std::vector<ScaledComplex> points_on_circles(const std::vector<double>& radii_log2);

/// Approximates all roots of a real polynomial, coefficients ascending, the first and the last not zero, by Ehrlich and
/// Aberth's simultaneous iteration in double precision from the radii of the Newton polygon. No guarantee: a root is
/// left where its value is below the rounding error of its evaluation, or after `max_sweeps` sweeps. Source:
/// [Bini1996].
std::vector<ScaledComplex> ehrlich_aberth(const std::vector<ScaledReal>& coefficients, int max_sweeps);

}  // namespace eliminant::numeric
