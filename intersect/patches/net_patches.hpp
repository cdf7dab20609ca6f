// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// A patch on [0, 1]^2 exactly and in doubles. Of two patches that are compared both have one origin.
struct PatchNets {
  const bridge::ExactNet& exact;
  const bridge::ControlNet& rounded;
};

/// A patch of exact control points as a map on [0, 1]^2.
symbolic::SurfacePiece patch_of(const bridge::ExactNet& net);

/// Its border curve on [0, 1]: where the parameter of the axis is 0 (side -1) or 1 (side 1).
symbolic::CurvePiece border_of(const bridge::ExactNet& net, std::size_t axis, int side);

}  // namespace eliminant::intersect
