// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/planar_seam.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <eliminant/bridge/contacts/common_border.hpp>
#include <eliminant/bridge/nets/exact_plane.hpp>
#include <eliminant/intersect/patches/only_common_point.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ExactNet;
using bridge::ExactPoint;
using symbolic::Rational;

/// The control points of a patch beside a plane.
class Heights {
 public:
  Heights(const ExactNet& net, const bridge::Plane& plane) : net_(net) {
    for (const ExactPoint& point : net.points) {
      Rational height;
      for (std::size_t k = 0; k < 4; ++k) height = height + plane[k] * point[k];
      signs_.push_back(height.sign());
    }
  }

  bool has_any(int sign) const { return std::find(signs_.begin(), signs_.end(), sign) != signs_.end(); }

  /// Whether the patch is on one side, and one border is all that it has in the plane, its own tips included. The
  /// Bernstein polynomials of the control points of a side of the square, and of no others, are positive within it.
  bool are_zero_only_along(std::size_t axis, int side) const {
    if (has_any(-1) == has_any(1) || !is_zero_along(axis, side) || !has_corner_above(axis, side)) return false;
    for (std::size_t other = 0; other < 2; ++other)
      for (const int end : {-1, 1}) {
        if (other == axis && end == side) continue;
        if (is_zero_along(other, end) && (other == axis || !is_one_point(net_, other, end))) return false;
      }
    return true;
  }

 private:
  int at(std::size_t i, std::size_t j) const { return signs_[i * (net_.degrees[1] + 1) + j]; }

  bool is_zero_along(std::size_t axis, int side) const {
    const std::size_t kept = side < 0 ? 0 : net_.degrees[axis];
    for (std::size_t k = 0; k <= net_.degrees[1 - axis]; ++k)
      if ((axis == 0 ? at(kept, k) : at(k, kept)) != 0) return false;
    return true;
  }

  /// Both corners on the other side of the square, unless they are tips of the border itself.
  bool has_corner_above(std::size_t axis, int side) const {
    const std::size_t opposite = side < 0 ? net_.degrees[axis] : 0;
    for (const int end : {-1, 1}) {
      const std::size_t last = end < 0 ? 0 : net_.degrees[1 - axis];
      const bool is_above = (axis == 0 ? at(opposite, last) : at(last, opposite)) != 0;
      if (!is_above && !is_one_point(net_, 1 - axis, end)) return false;
    }
    return true;
  }

  const ExactNet& net_;
  std::vector<int> signs_;
};

std::vector<ExactPoint> points_along(const ExactNet& net, std::size_t axis, int side) {
  const std::size_t row = net.degrees[1] + 1;
  const std::size_t kept = side < 0 ? 0 : net.degrees[axis];
  std::vector<ExactPoint> points;
  for (std::size_t k = 0; k <= net.degrees[1 - axis]; ++k)
    points.push_back(net.points[axis == 0 ? kept * row + k : k * row + kept]);
  return points;
}

}  // namespace

std::optional<bridge::ContainedBorder> planar_seam(const bridge::PatchPairNets& nets) {
  for (std::size_t axis = 0; axis < 4; ++axis)
    for (const int side : {-1, 1}) {
      const ExactNet& own = axis < 2 ? nets.exact_first : nets.exact_second;
      const ExactNet& other = axis < 2 ? nets.exact_second : nets.exact_first;
      const auto plane = bridge::plane_through(points_along(own, axis % 2, side));
      if (!plane) continue;
      const Heights heights(own, *plane);
      if (!heights.are_zero_only_along(axis % 2, side)) continue;
      // The other patch nowhere on that side: what both have in common is in the plane.
      if (Heights(other, *plane).has_any(heights.has_any(1) ? 1 : -1)) continue;
      if (bridge::is_common_border(nets, axis, side)) return bridge::ContainedBorder{axis, side};
    }
  return std::nullopt;
}

}  // namespace eliminant::intersect
