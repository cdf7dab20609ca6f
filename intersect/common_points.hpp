// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/bridge/ball_surface.hpp>
#include <eliminant/bridge/krawczyk_system.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// The functions of (a, b, t), a and b two of the homogeneous parameters and the others fixed, that vanish where the
/// surface and the curve are at the same point: the minors of their coordinates that contain the one of index `pivot`,
/// which must not vanish there. `surface` and `curve` must outlive the result.
bridge::System common_point_system(const bridge::BallSurface& surface, const symbolic::RationalCurve& curve,
                                   const bridge::HomogeneousParameters& parameters,
                                   std::array<std::size_t, 2> variables, std::size_t pivot);

}  // namespace eliminant::intersect
