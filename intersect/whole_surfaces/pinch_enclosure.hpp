// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/intersect/whole_surfaces/surface_charts.hpp>

namespace eliminant::intersect {

/// The only point in or next to a rectangle at which the surface has no two independent tangents: its derivative along
/// one direction (1, m) or (m, 1) of the parameters vanishes, three equations for both parameters and m. Enclosed in
/// the digits of doubles; nullopt where existence or uniqueness is not proven.
///
/// `surface` of tensor-product kind; parameters in the charts `inverted`. Source: [Krawczyk1969].
std::optional<std::array<DoubleInterval, 2>> enclose_pinch_point(const symbolic::RationalSurface& surface,
                                                                 const std::array<bool, 2>& inverted,
                                                                 const std::array<DoubleInterval, 2>& within);

}  // namespace eliminant::intersect
