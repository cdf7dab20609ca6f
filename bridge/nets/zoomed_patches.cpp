// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/zoomed_patches.hpp>

#include <cstddef>
#include <utility>

#include <eliminant/bridge/nets/bezier_part.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Rational;

/// The control points of one line become those of its part: the i-th is the blossom at i times `upper`, otherwise
/// `lower`.
void restrict_line(ExactPoint* points, std::size_t degree, std::size_t stride, const Rational& lower,
                   const Rational& upper) {
  std::vector<ExactPoint> result;
  for (std::size_t i = 0; i <= degree; ++i) {
    std::vector<ExactPoint> row;
    for (std::size_t k = 0; k <= degree; ++k) row.push_back(points[k * stride]);
    for (std::size_t level = 0; level < degree; ++level) {
      const Rational& t = level < i ? upper : lower;
      for (std::size_t k = 0; k + level < degree; ++k)
        for (std::size_t c = 0; c < 4; ++c) row[k][c] = row[k][c] + t * (row[k + 1][c] - row[k][c]);
    }
    result.push_back(std::move(row.front()));
  }
  for (std::size_t i = 0; i <= degree; ++i) points[i * stride] = std::move(result[i]);
}

}  // namespace

ExactNet restricted(const ExactNet& net, const std::array<Rational, 2>& lower, const Rational& width) {
  ExactNet result = net;
  const NetShape<2> shape{{net.degrees[0], net.degrees[1]}};
  for (std::size_t axis = 0; axis < 2; ++axis)
    shape.for_each_line(axis, [&](std::size_t base) {
      restrict_line(result.points.data() + base, shape.degree[axis], shape.stride(axis), lower[axis],
                    lower[axis] + width);
    });
  return result;
}

std::optional<ZoomedPatches> ZoomedPatches::around(const PatchPairNets& nets, const std::array<Rational, 4>& centre,
                                                   double half) {
  ZoomedPatches result;
  result.exact_centre_ = centre;
  result.half_ = half;
  const Rational exact_half = exactly(half);
  const Rational width = exact_half + exact_half;
  for (std::size_t k = 0; k < 4; ++k) result.centre_[k] = nearest(centre[k]);
  result.exact_first_ = restricted(nets.exact_first, {centre[0] - exact_half, centre[1] - exact_half}, width);
  result.exact_second_ = restricted(nets.exact_second, {centre[2] - exact_half, centre[3] - exact_half}, width);
  const PatchJets::Value middle = PatchJets(nets.first).at(result.centre_[0], result.centre_[1]);
  for (std::size_t k = 0; k < 3; ++k) {
    result.shift_[k] = middle.point[static_cast<long>(k)];
    result.origin_[k] = nets.origin[k] + exactly(result.shift_[k]);
  }
  auto first = ControlNet::round(result.exact_first_.degrees, result.exact_first_.points, result.origin_);
  auto second = ControlNet::round(result.exact_second_.degrees, result.exact_second_.points, result.origin_);
  if (!first || !second) return std::nullopt;
  result.first_ = *std::move(first);
  result.second_ = *std::move(second);
  return result;
}

std::array<double, 4> ZoomedPatches::zoomed(const std::array<double, 4>& parameters) const {
  std::array<double, 4> result{};
  for (std::size_t k = 0; k < 4; ++k) result[k] = 0.5 + (parameters[k] - centre_[k]) / (2 * half_);
  return result;
}

TracedPoint ZoomedPatches::original(const TracedPoint& point) const {
  TracedPoint result;
  for (std::size_t k = 0; k < 4; ++k) result.parameters[k] = centre_[k] + 2 * half_ * (point.parameters[k] - 0.5);
  for (std::size_t k = 0; k < 3; ++k) result.point[k] = shift_[k] + point.point[k];
  return result;
}

}  // namespace eliminant::bridge
