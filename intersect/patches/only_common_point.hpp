// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <eliminant/intersect/patches/net_patches.hpp>

namespace eliminant::intersect {

/// Whether the border of a patch (axis 0 or 1, side -1 or 1) is one point: all of its control points are, exactly.
bool is_one_point(const bridge::ExactNet& net, std::size_t axis, int side);

/// A point of two patches with its parameters (u, v, s, t), nullopt where every value has the point.
struct CommonPoint {
  std::array<std::optional<symbolic::Rational>, 4> parameters;
  std::array<int, 4> side() const;
};

/// Two tensor-product patches with positive weights on [0, 1]^2 that have one point in common, which is a corner or a
/// border that is one point of one of them. Proven by a plane through the point that has the rest of that patch on one
/// side and the other patch on the other side or in the plane; nullopt where a few likely planes do not show it, or the
/// parameters of the point are not simple fractions.
std::optional<CommonPoint> only_common_point(const PatchNets& first, const PatchNets& second);

}  // namespace eliminant::intersect
