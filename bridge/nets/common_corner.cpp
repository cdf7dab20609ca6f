// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/common_corner.hpp>

#include <cstddef>

#include <Eigen/Core>

#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::bridge {

namespace {

using Eigen::Vector3d;
using symbolic::Rational;

constexpr std::size_t weight = 3;

std::size_t corner_index(const ExactNet& net, std::size_t corner) {
  const std::size_t row = net.degrees[1] + 1;
  return (corner / 2 == 0 ? 0 : net.degrees[0]) * row + (corner % 2 == 0 ? 0 : net.degrees[1]);
}

bool are_equal(const ExactPoint& p, const ExactPoint& q) {
  for (std::size_t k = 0; k < weight; ++k)
    if (!(p[k] * q[weight] == q[k] * p[weight])) return false;
  return true;
}

Vector3d rounded(const ExactPoint& p) {
  return {nearest(p[0] / p[weight]), nearest(p[1] / p[weight]), nearest(p[2] / p[weight])};
}

/// The sum of the unit vectors from a corner to the control points next to it on both borders.
Vector3d way_inside(const ExactNet& net, std::size_t corner) {
  const std::size_t row = net.degrees[1] + 1;
  const std::size_t at = corner_index(net, corner);
  const std::size_t down = corner / 2 == 0 ? at + row : at - row;
  const std::size_t across = corner % 2 == 0 ? at + 1 : at - 1;
  const Vector3d start = rounded(net.points[at]);
  Vector3d sum = Vector3d::Zero();
  for (const std::size_t next : {down, across}) {
    const Vector3d step = rounded(net.points[next]) - start;
    if (step.norm() > 0) sum += step.normalized();
  }
  return sum;
}

Vector3d centre(const ExactNet& net) {
  Vector3d sum = Vector3d::Zero();
  for (const ExactPoint& point : net.points) sum += rounded(point);
  return sum / static_cast<double>(net.points.size());
}

/// Whether the height above the plane through the corner has that sign at all other control points, and is perhaps 0.
bool is_on_side(const ExactNet& net, const ExactPoint& corner, std::size_t corner_at, const Vector3d& normal, int sign,
                bool strictly) {
  for (std::size_t i = 0; i < net.points.size(); ++i) {
    if (i == corner_at) continue;
    Rational height;
    for (std::size_t k = 0; k < weight; ++k)
      height = height + exactly(normal[static_cast<long>(k)]) *
                            (net.points[i][k] * corner[weight] - corner[k] * net.points[i][weight]);
    const int side = height.sign() * sign;
    if (side < 0 || (strictly && side == 0)) return false;
  }
  return true;
}

/// Small multiples of a power of two are as good, and exact tests with them are quick.
Vector3d shortened(const Vector3d& normal) {
  constexpr double steps = 64;
  return (normal / normal.cwiseAbs().maxCoeff() * steps).array().round().matrix();
}

}  // namespace

std::optional<std::array<int, 4>> only_common_corner(const ExactNet& first, const ExactNet& second) {
  std::optional<std::array<std::size_t, 2>> corners;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      if (!are_equal(first.points[corner_index(first, i)], second.points[corner_index(second, j)])) continue;
      if (corners) return std::nullopt;
      corners = {i, j};
    }
  if (!corners) return std::nullopt;
  const auto& [a, b] = *corners;
  const std::size_t at = corner_index(first, a);
  const ExactPoint& corner = first.points[at];
  for (const Vector3d& normal :
       {Vector3d(way_inside(second, b) - way_inside(first, a)), Vector3d(centre(second) - centre(first)),
        Vector3d(centre(second) - rounded(corner)), Vector3d(rounded(corner) - centre(first))}) {
    if (!normal.allFinite() || !(normal.norm() > 0)) continue;
    const Vector3d simple = shortened(normal);
    if (!is_on_side(first, corner, at, simple, -1, true)) continue;
    if (!is_on_side(second, corner, corner_index(second, b), simple, 1, false)) continue;
    return std::array<int, 4>{a / 2 == 0 ? -1 : 1, a % 2 == 0 ? -1 : 1, b / 2 == 0 ? -1 : 1, b % 2 == 0 ? -1 : 1};
  }
  return std::nullopt;
}

}  // namespace eliminant::bridge
