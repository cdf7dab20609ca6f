// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/bridge/certificates/krawczyk_system.hpp>
#include <eliminant/bridge/enclosures/ball_surface.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// The functions of (a, b, t), a and b two of the homogeneous parameters and the others fixed, that vanish where the
/// surface and the curve are at the same point: the minors of their coordinates that contain the one of index `pivot`,
/// which must not vanish there. `surface` and `curve` must outlive the result.
bridge::System common_point_system(const bridge::BallSurface& surface, const symbolic::RationalCurve& curve,
                                   const bridge::HomogeneousParameters& parameters,
                                   std::array<std::size_t, 2> variables, std::size_t pivot);

/// The functions of (t, u) that vanish where two plane curves are at the same point: minors of their coordinates that
/// contain the weight, which must not vanish there. The curves must outlive the result.
bridge::System common_point_system(const symbolic::RationalCurve& first, const symbolic::RationalCurve& second);

/// The indices of the two parameters that vary where the others are 1; nullopt when there is no such chart.
std::optional<std::array<std::size_t, 2>> chart_variables(const bridge::BallSurface& surface,
                                                          const bridge::HomogeneousParameters& parameters);

/// Newton's steps that lead from the accuracy of doubles to this precision.
int newton_steps(long precision_bits);

/// A simple common point with its digits; nullopt when the balls are too wide for them, or a number may be 0.
std::optional<CurveSolution> print_common_point(const bridge::BallSurface& surface,
                                                const symbolic::RationalCurve& curve,
                                                const bridge::HomogeneousParameters& parameters,
                                                const bridge::ComplexBall& t, const Options& options,
                                                long precision_bits);

/// The same of a common point of two curves, with the point as the first one has it.
std::optional<CurveSolution> print_common_point(const symbolic::RationalCurve& first, const bridge::ComplexBall& t,
                                                const bridge::ComplexBall& u, const Options& options,
                                                long precision_bits);

}  // namespace eliminant::intersect
