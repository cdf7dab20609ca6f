// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>

#include <eliminant/numeric/rational_forms.hpp>

namespace eliminant::numeric {

/// Parameters of a surface and a curve at which they nearly meet, and how Newton's iteration changed them.
template <class Scalar>
struct CommonPointGuess {
  ParameterChart<Scalar> chart;
  std::array<Scalar, 2> t{};   ///< (t_0 : t_1), one of them 1
  std::size_t t_variable = 0;  ///< which one varies
  double first_step = 0;
  double step = 0;      ///< the last one
  double moved = 0;     ///< sum of all
  double distance = 1;  ///< sine of the angle between both points: of the start, or before the last step
};

/// Newton's iteration for all three parameters at once. True when it has settled: the step eta, the size beta of the
/// inverse of the derivative and a bound K of the second derivatives satisfy beta K eta < 1/10, as in the theorem of
/// Newton and Kantorovich, where the step includes what rounding may do to it. It has not at multiple points, base
/// points, and those too near to another one for doubles.
/// `surface_norm` is the Frobenius norm of the surface's coefficients. Guarantee: none (floating point).
template <class Scalar>
bool settle_common_point(const SurfaceForms& surface, double surface_norm, const CurveForms& curve,
                         CommonPointGuess<Scalar>& guess);

extern template bool settle_common_point(const SurfaceForms&, double, const CurveForms&, CommonPointGuess<double>&);
extern template bool settle_common_point(const SurfaceForms&, double, const CurveForms&,
                                         CommonPointGuess<std::complex<double>>&);

}  // namespace eliminant::numeric
