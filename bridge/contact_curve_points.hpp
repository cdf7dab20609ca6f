// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/bridge/control_net.hpp>

namespace eliminant::bridge {

/// Points (u, v, s, t) of a curve along which two patches seem to touch, in doubles, in and a little around the domains;
/// proves nothing. Empty where Newton's method finds no such curve within `reach` of `near`, or it is short beyond use.
///
/// The conditions of a contact have a Jacobian matrix of rank three along the curve: steps orthogonal to its kernel lead
/// to the curve, steps along it from point to point.
std::vector<std::array<double, 4>> contact_curve_points(const ControlNet& first, const ControlNet& second,
                                                        const std::array<double, 4>& near, double reach);

}  // namespace eliminant::bridge
