// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/net_patches.hpp>

#include <vector>

#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::intersect {

symbolic::CurvePiece border_of(const bridge::ExactNet& net, std::size_t axis, int side) {
  const std::size_t row = net.degrees[1] + 1;
  const std::size_t kept = side < 0 ? 0 : net.degrees[axis];
  std::vector<symbolic::ControlPoint> points;
  for (std::size_t i = 0; i <= net.degrees[1 - axis]; ++i) {
    const bridge::ExactPoint& point = net.points[axis == 0 ? kept * row + i : i * row + kept];
    points.emplace_back(point.begin(), point.end());
  }
  return symbolic::bezier_curve(points);
}

symbolic::SurfacePiece patch_of(const bridge::ExactNet& net) {
  const std::size_t row = net.degrees[1] + 1;
  std::vector<std::vector<symbolic::ControlPoint>> rows(net.degrees[0] + 1);
  for (std::size_t i = 0; i < net.points.size(); ++i)
    rows[i / row].emplace_back(net.points[i].begin(), net.points[i].end());
  return symbolic::bezier_patch(rows);
}

}  // namespace eliminant::intersect
