// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/section_frame.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ControlNet;
using bridge::nearest;
using symbolic::Rational;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SectionFrame::SectionFrame(const symbolic::SurfacePiece& patch, PreparedNet net)
    : domain_(patch.region->sides),
      net_(std::move(net)),
      weight_has_one_sign_(std::all_of(net_.exact.points.begin(), net_.exact.points.end(),
                                       [](const bridge::ExactPoint& p) { return p[3].sign() > 0; })) {}

bool SectionFrame::round() {
  // Far from infinity a point of the patch makes the coordinates small.
  if (weight_has_one_sign_) origin_ = net_.origin();
  auto rounded = net_.rounded(origin_);
  if (!rounded) return false;
  nets_ = {*rounded, *rounded};
  for (Eigen::Array4d& point : nets_[1].points) point = -point;
  return true;
}

double SectionFrame::to_domain(std::size_t k, double local) const {
  const double lower = nearest(domain_[k].lower);
  const double upper = nearest(domain_[k].upper);
  return local == 1 ? upper : lower + local * (upper - lower);
}

std::array<double, 2> SectionFrame::to_local(const std::array<double, 2>& parameters) const {
  std::array<double, 2> local;
  for (std::size_t k = 0; k < 2; ++k) {
    const double lower = nearest(domain_[k].lower);
    local[k] = (parameters[k] - lower) / (nearest(domain_[k].upper) - lower);
  }
  return local;
}

double SectionFrame::to_local_length(double length) const {
  double result = 0;
  for (const symbolic::Interval& side : domain_) result = std::max(result, length / nearest(side.upper - side.lower));
  return result;
}

bridge::SectionGoal SectionFrame::place_of(const TopologyVertex& vertex, const std::array<int, 2>& side) const {
  bridge::SectionGoal goal;
  for (std::size_t k = 0; k < 2; ++k) {
    constexpr long bits = 128;
    bridge::RealBall local;
    arb_set_fmpq(local.get(), domain_[k].lower.get(), bits);
    arb_sub(local.get(), (k == 0 ? vertex.x : vertex.y).ball.real(), local.get(), bits);
    bridge::RealBall width(domain_[k].upper - domain_[k].lower, bits);
    arb_div(local.get(), local.get(), width.get(), bits);
    goal.at[k] = std::clamp(arf_get_d(arb_midref(local.get()), ARF_RND_NEAR), 0.0, 1.0);
    if (side[k] != 0) goal.at[k] = side[k] < 0 ? 0 : 1;
    goal.radius = std::max(goal.radius, mag_get_d(arb_radref(local.get())) + 0x1p-52);
  }
  return goal;
}

SurfacePoint SectionFrame::placed(const std::array<double, 2>& local, const std::array<double, 3>& point) const {
  SurfacePoint result;
  result.parameters = {to_domain(0, local[0]), to_domain(1, local[1]), unknown, unknown};
  for (std::size_t k = 0; k < 3; ++k) result.point[k] = point[k] + nearest(origin_[k]);
  return result;
}

SurfacePoint SectionFrame::corner(std::size_t u, std::size_t v) const {
  const std::size_t row = net_.exact.degrees[1] + 1;
  const bridge::ExactPoint& exact =
      net_.exact.points[(u == 0 ? 0 : net_.exact.degrees[0] * row) + (v == 0 ? 0 : row - 1)];
  SurfacePoint result;
  result.parameters = {to_domain(0, static_cast<double>(u)), to_domain(1, static_cast<double>(v)), unknown, unknown};
  for (std::size_t k = 0; k < 3; ++k) result.point[k] = exact[3].is_zero() ? unknown : nearest(exact[k] / exact[3]);
  return result;
}

}  // namespace eliminant::intersect
