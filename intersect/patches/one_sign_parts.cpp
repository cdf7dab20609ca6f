// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/one_sign_parts.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <eliminant/intersect/curve_surface/prepared_net.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Interval;
using symbolic::Rational;
using symbolic::SurfacePiece;

constexpr std::size_t weight = 3;
constexpr std::size_t most_levels = 10;
constexpr std::size_t most_parts = 256;

Rational cut_of(const Interval& side, std::size_t which, std::size_t axis) {
  constexpr std::array<std::array<long, 2>, 3> in_64ths{{{31, 34}, {35, 30}, {33, 29}}};
  return side.lower + Rational(in_64ths[which][axis]) / Rational(64) * (side.upper - side.lower);
}

/// Where both parameters are at a bound the coefficients are values of the weight.
std::array<int, 4> signs_at_corners(const bridge::ExactNet& net) {
  const std::size_t n = net.degrees[1];
  const std::size_t last = net.points.size() - 1;
  std::array<int, 4> signs{};
  std::size_t k = 0;
  for (const std::size_t i : {std::size_t{0}, n, last - n, last}) signs[k++] = net.points[i][weight].sign();
  return signs;
}

bool has_one_sign(const bridge::ExactNet& net) {
  const int first = net.points.front()[weight].sign();
  return first != 0 &&
         std::all_of(net.points.begin(), net.points.end(), [&](const auto& p) { return p[weight].sign() == first; });
}

std::array<SurfacePiece, 4> quarters(const SurfacePiece& patch, std::size_t which) {
  std::array<SurfacePiece, 4> result{patch, patch, patch, patch};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Rational cut = cut_of(patch.region->sides[axis], which, axis);
    for (std::size_t i = 0; i < 4; ++i) {
      Interval& side = result[i].region->sides[axis];
      const bool upper = axis == 0 ? i >= 2 : i % 2 == 1;
      (upper ? side.lower : side.upper) = cut;
    }
  }
  return result;
}

}  // namespace

OneSignParts one_sign_parts(const SurfacePiece& patch, std::size_t which) {
  std::vector<SurfacePiece> done;
  std::vector<SurfacePiece> open{patch};
  int sign = 0;
  for (std::size_t level = 0; !open.empty(); ++level) {
    std::vector<SurfacePiece> next;
    for (SurfacePiece& piece : open) {
      const auto net = prepared_net(piece);
      if (!net) return {WeightSigns::one, {patch}};
      for (const int corner : signs_at_corners(net->exact)) {
        if (sign == 0) sign = corner;
        if (corner != sign || corner == 0) return {WeightSigns::both, {patch}};
      }
      if (has_one_sign(net->exact)) {
        done.push_back(std::move(piece));
        continue;
      }
      for (SurfacePiece& part : quarters(piece, which)) next.push_back(std::move(part));
    }
    open = std::move(next);
    if (!open.empty() && (level == most_levels || done.size() + open.size() > most_parts))
      return {WeightSigns::undecided, {patch}};
  }
  return {WeightSigns::one, std::move(done)};
}

}  // namespace eliminant::intersect
