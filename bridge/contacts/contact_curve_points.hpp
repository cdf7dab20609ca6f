// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// A point (u, v, s, t) of a curve along which two patches seem to touch, in doubles, within `reach` of `near`, by
/// Newton's method with the least of all steps: the conditions of a contact have a Jacobian matrix of rank three along
/// the curve. nullopt where there is none; proves nothing.
std::optional<std::array<double, 4>> contact_curve_point(const ControlNet& first, const ControlNet& second,
                                                         const std::array<double, 4>& near, double reach);

/// Points all along that curve in and a little around the domains, by steps along the kernel of the matrix. Empty where
/// the curve is short beyond use.
std::vector<std::array<double, 4>> contact_curve_points(const ControlNet& first, const ControlNet& second,
                                                        const std::array<double, 4>& on_curve);

/// Points (u, v, s, t) of a border curve that lies in the other patch, spread over its part; none where Newton's method
/// does not find the parameters of the other patch.
std::vector<std::array<double, 4>> points_along_border(const ControlNet& first, const ControlNet& second,
                                                       const ContainedBorder& border);

}  // namespace eliminant::bridge
