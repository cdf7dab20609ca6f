// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/balanced_pair.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/patches/prepared_patch.hpp>

namespace eliminant::intersect {

using bridge::ControlNet;
using bridge::nearest;
using Eigen::Array4d;

BalancedPair::BalancedPair(PreparedNet first, PreparedNet second)
    : first_(std::move(first)), second_(std::move(second)) {
  if (!has_positive_weights(first_) || !has_positive_weights(second_)) {
    obstacle_ = "a patch has weights of both signs or zero: it was not intersected";
    return;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    balance_[k] = balance_weights(k < 2 ? first_ : second_, k % 2);
    const symbolic::Interval& side = k < 2 ? first_.domain[k] : second_.domain[k - 2];
    bounds_[k] = {nearest(side.lower), nearest(side.upper)};
  }
  origin_ = first_.origin();
  for (std::size_t k = 0; k < 3; ++k) rounded_origin_[k] = nearest(origin_[k]);
  auto rounded_first = first_.rounded(origin_);
  auto rounded_second = second_.rounded(origin_);
  if (!rounded_first || !rounded_second) {
    obstacle_ = "coordinates are beyond the range in which hardware doubles are safe";
    return;
  }
  first_net_ = *std::move(rounded_first);
  second_net_ = *std::move(rounded_second);
}

double BalancedPair::size() const { return std::min(size_of(first_), size_of(second_)); }

double BalancedPair::to_domain(std::size_t k, double local) const {
  const auto& [lower, upper] = bounds_[k];
  const double c = balance_[k];
  const double place = c == 1 ? local : c * local / ((1 - local) + c * local);
  return place == 1 ? upper : lower + place * (upper - lower);
}

SurfacePoint BalancedPair::placed(const std::array<double, 4>& parameters, const std::array<double, 3>& point) const {
  SurfacePoint result;
  for (std::size_t k = 0; k < 4; ++k) result.parameters[k] = to_domain(k, parameters[k]);
  for (std::size_t k = 0; k < 3; ++k) result.point[k] = point[k] + rounded_origin_[k];
  return result;
}

SurfacePoint BalancedPair::placed(const std::array<double, 4>& parameters) const {
  const bridge::PatchJets::Value value = bridge::PatchJets(first_net_).at(parameters[0], parameters[1]);
  return placed(parameters, {value.point[0], value.point[1], value.point[2]});
}

SurfaceComponent BalancedPair::placed(SurfaceComponentKind kind, const DrawnCurve& drawn) const {
  SurfaceComponent component;
  component.kind = kind;
  component.certified = true;
  for (std::size_t i = 0; i < drawn.points.size(); ++i)
    component.points.push_back(placed(drawn.parameters[i], drawn.points[i]));
  component.error = drawn.error + rounding_of(component);
  return component;
}

void BalancedPair::put_on_border(SurfacePoint& point, const BranchEnd& end) const {
  for (std::size_t k = 0; k < 4; ++k)
    if (end.side[k] != 0) point.parameters[k] = to_domain(k, end.side[k] < 0 ? 0 : 1);
}

double BalancedPair::rounding_of(const SurfaceComponent& component) const {
  double largest = 0;
  for (const SurfacePoint& point : component.points)
    for (const double x : point.point) largest = std::max(largest, std::fabs(x));
  for (const double x : rounded_origin_) largest = std::max(largest, std::fabs(x));
  return 4 * largest * 0x1p-53;
}

double BalancedPair::error_in_space(const bridge::CrossingPoint& point) const {
  bridge::PatchJets patch(first_net_);
  const double reach = point.radius + 0x1p-20;
  const auto bounds = patch.bounds_on(point.parameters[0] - reach, point.parameters[0] + reach,
                                      point.parameters[1] - reach, point.parameters[1] + reach);
  if (!bounds) return INFINITY;
  const double speed = (bounds->first[0] + bounds->first[1]).head<3>().matrix().norm();
  return speed * point.radius + 1.74 * patch.at(point.parameters[0], point.parameters[1]).error;
}

bool BalancedPair::is_tangential(const std::array<double, 4>& parameters) const {
  const auto normal_at = [](const ControlNet& net, double u, double v) {
    const auto slope = [&](double a, double b, std::size_t axis) {
      return Eigen::Vector3d(bridge::PatchJets(net).at(a, b).first[axis].head<3>().matrix());
    };
    Eigen::Vector3d p = slope(u, v, 0);
    Eigen::Vector3d q = slope(u, v, 1);
    // Along a border that is one point: two directions in which the patch leaves it.
    const auto elsewhere = [](double x) { return x < 0.5 ? x + 0.5 : x - 0.5; };
    constexpr double nothing = 1e-12;
    if (p.norm() <= nothing * q.norm()) p = slope(elsewhere(u), v, 1);
    if (q.norm() <= nothing * p.norm()) q = slope(u, elsewhere(v), 0);
    return Eigen::Vector3d(p.cross(q).normalized());
  };
  const Eigen::Vector3d a = normal_at(first_net_, parameters[0], parameters[1]);
  const Eigen::Vector3d b = normal_at(second_net_, parameters[2], parameters[3]);
  constexpr double least_angle = 1e-7;
  return !(a.cross(b).norm() > least_angle);
}

SurfaceComponent BalancedPair::placed(const ContactArc& arc) const {
  SurfaceComponent component;
  component.kind = arc.closed ? SurfaceComponentKind::loop : SurfaceComponentKind::curve;
  for (const bridge::TracedPoint& point : arc.points) component.points.push_back(placed(point.parameters, point.point));
  component.error = arc.error + rounding_of(component);
  component.start.side = arc.start.side;
  component.end.side = arc.end.side;
  if (arc.closed) return component;
  put_on_border(component.points.front(), component.start);
  put_on_border(component.points.back(), component.end);
  return component;
}

Transition BalancedPair::transition_at(const std::array<double, 4>& parameters, const std::array<int, 4>& side) const {
  const auto on_border = std::find_if(side.begin(), side.end(), [](int s) { return s != 0; });
  const auto axis = static_cast<std::size_t>(on_border - side.begin());
  const bridge::PatchJets::Value a = bridge::PatchJets(first_net_).at(parameters[0], parameters[1]);
  const bridge::PatchJets::Value b = bridge::PatchJets(second_net_).at(parameters[2], parameters[3]);
  const bridge::PatchJets::Value& own = axis < 2 ? a : b;
  const bridge::PatchJets::Value& other = axis < 2 ? b : a;
  const Array4d& along_border = own.first[1 - axis % 2];
  const Array4d& p = other.first[0];
  const Array4d& q = other.first[1];
  const std::array<double, 3> normal{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  double sum = 0;
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += along_border[static_cast<long>(k)] * normal[k];
    size += std::fabs(along_border[static_cast<long>(k)] * normal[k]);
  }
  constexpr double undecided = 1e-10;
  if (!(std::fabs(sum) > undecided * size)) return Transition::touching;
  return sum > 0 ? Transition::out : Transition::in;
}

}  // namespace eliminant::intersect
