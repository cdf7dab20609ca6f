// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// A plane a x + b y + c z + d w = 0.
using Plane = std::array<symbolic::Rational, 4>;

/// The plane through all points, where there is exactly one.
std::optional<Plane> plane_through(std::vector<ExactPoint> points);

}  // namespace eliminant::bridge
