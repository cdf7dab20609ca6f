// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/only_common_point.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/bridge/rounding/simple_fraction.hpp>
#include <eliminant/intersect/overlaps/patch_inversion.hpp>

namespace eliminant::intersect {

namespace {

using bridge::exactly;
using bridge::ExactNet;
using bridge::ExactPoint;
using bridge::nearest;
using Eigen::Vector3d;
using symbolic::Rational;

constexpr std::size_t weight = 3;

bool are_equal(const ExactPoint& p, const ExactPoint& q) {
  for (std::size_t k = 0; k < weight; ++k)
    if (!(p[k] * q[weight] == q[k] * p[weight])) return false;
  return true;
}

std::size_t index_of(const ExactNet& net, std::size_t i, std::size_t j) { return i * (net.degrees[1] + 1) + j; }

Vector3d rounded(const ExactPoint& p) {
  return {nearest(p[0] / p[weight]), nearest(p[1] / p[weight]), nearest(p[2] / p[weight])};
}

/// A corner, or a border that is one point: -1, 1, or 0 for a parameter that runs along that border.
struct Tip {
  std::array<int, 2> side{};
  ExactPoint point;

  /// How many lines of control points away from it, in the direction in which it ends the patch.
  std::size_t distance(const ExactNet& net, std::size_t i, std::size_t j) const {
    const std::size_t along_u = side[0] < 0 ? i : side[0] > 0 ? net.degrees[0] - i : 0;
    const std::size_t along_v = side[1] < 0 ? j : side[1] > 0 ? net.degrees[1] - j : 0;
    return along_u + along_v;
  }
};

std::vector<Tip> tips_of(const ExactNet& net) {
  std::vector<Tip> tips;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (const int side : {-1, 1}) {
      if (!is_one_point(net, axis, side)) continue;
      Tip tip;
      tip.side[axis] = side;
      tip.point = net.points[side < 0 ? 0 : net.points.size() - 1];
      tips.push_back(tip);
    }
  for (const int u : {-1, 1})
    for (const int v : {-1, 1}) {
      const ExactPoint& point = net.points[index_of(net, u < 0 ? 0 : net.degrees[0], v < 0 ? 0 : net.degrees[1])];
      const auto known = [&](const Tip& tip) { return are_equal(tip.point, point); };
      if (std::none_of(tips.begin(), tips.end(), known)) tips.push_back({{u, v}, point});
    }
  return tips;
}

/// The mean of the control points at that distance from a tip.
Vector3d mean_at(const ExactNet& net, const Tip& tip, std::size_t distance) {
  Vector3d sum = Vector3d::Zero();
  double count = 0;
  for (std::size_t i = 0; i <= net.degrees[0]; ++i)
    for (std::size_t j = 0; j <= net.degrees[1]; ++j) {
      if (tip.distance(net, i, j) != distance) continue;
      sum += rounded(net.points[index_of(net, i, j)]);
      count += 1;
    }
  return count > 0 ? Vector3d(sum / count) : rounded(tip.point);
}

Vector3d mean(const ExactNet& net) {
  Vector3d sum = Vector3d::Zero();
  for (const ExactPoint& point : net.points) sum += rounded(point);
  return sum / static_cast<double>(net.points.size());
}

/// The sign of the height of a control point above the plane through the tip.
int height_sign(const ExactPoint& point, const ExactPoint& tip, const Vector3d& normal) {
  Rational height;
  for (std::size_t k = 0; k < weight; ++k)
    height = height + exactly(normal[static_cast<long>(k)]) * (point[k] * tip[weight] - tip[k] * point[weight]);
  return height.sign();
}

/// The patch is below the plane but for the tip. No control point is above, and where no other one but those of the tip
/// could be in the plane the Bernstein polynomials of some that are below it are positive.
bool is_below(const ExactNet& net, const Tip& tip, const Vector3d& normal) {
  const bool corner = tip.side[0] != 0 && tip.side[1] != 0;
  const std::size_t opposite = tip.side[0] != 0 ? net.degrees[0] : net.degrees[1];
  for (std::size_t i = 0; i <= net.degrees[0]; ++i)
    for (std::size_t j = 0; j <= net.degrees[1]; ++j) {
      const std::size_t distance = tip.distance(net, i, j);
      if (distance == 0) continue;
      const int sign = height_sign(net.points[index_of(net, i, j)], tip.point, normal);
      if (sign > 0 || (sign == 0 && (corner || distance == opposite))) return false;
    }
  return true;
}

bool is_nowhere_below(const ExactNet& net, const ExactPoint& tip, const Vector3d& normal) {
  return std::all_of(net.points.begin(), net.points.end(),
                     [&](const ExactPoint& point) { return height_sign(point, tip, normal) >= 0; });
}

/// Few digits make exact tests quick, and are as good; none are lost of a normal of a simple plane.
Vector3d shortened(const Vector3d& normal) {
  constexpr double steps = 0x1p20;
  return (normal / normal.cwiseAbs().maxCoeff() * steps).array().round().matrix();
}

/// Whether a plane has the first, but for its tip, below, and the second nowhere below.
bool are_separated(const ExactNet& first, const Tip& tip, const ExactNet& second, const Vector3d& way_into_second,
                   const Vector3d& normal_of_second) {
  const Vector3d corner = rounded(tip.point);
  const Vector3d away = corner - mean_at(first, tip, 1);
  const auto unit = [](const Vector3d& v) { return v.norm() > 0 ? Vector3d(v.normalized()) : v; };
  const double up = away.dot(normal_of_second) >= 0 ? 1 : -1;
  for (const Vector3d& normal :
       {Vector3d(unit(away) + unit(way_into_second)), away, Vector3d(mean(second) - mean(first)),
        Vector3d(up * normal_of_second), Vector3d(corner - mean(first))}) {
    if (!normal.allFinite() || !(normal.norm() > 0)) continue;
    const Vector3d simple = shortened(normal);
    if (is_below(first, tip, simple) && is_nowhere_below(second, tip.point, simple)) return true;
  }
  return false;
}

Vector3d normal_at(const bridge::ControlNet& net, const std::array<double, 2>& at) {
  const bridge::PatchJets::Value value = bridge::PatchJets(net).at(at[0], at[1]);
  const Vector3d p = value.first[0].head<3>().matrix();
  const Vector3d q = value.first[1].head<3>().matrix();
  return p.cross(q);
}

/// The parameters of a point on a patch, exactly; `at` are near them.
std::optional<std::array<Rational, 2>> located(const PatchNets& patch, const ExactPoint& point,
                                               const std::array<double, 2>& at) {
  std::array<Rational, 2> result;
  for (std::size_t k = 0; k < 2; ++k) {
    constexpr double accuracy = 1e-12;
    const auto fraction = bridge::simple_fraction(at[k], accuracy);
    if (!fraction || fraction->sign() < 0 || Rational(1) < *fraction) return std::nullopt;
    result[k] = *fraction;
  }
  if (!are_equal(bridge::taylor_at(patch.exact, result, 0).at(0, 0), point)) return std::nullopt;
  return result;
}

/// The tip of a patch on the other one; `origin` is that of the nets in doubles.
std::optional<CommonPoint> at_tip(const PatchNets& first, const Tip& tip, const PatchNets& second) {
  bridge::PatchJets own(first.rounded);
  bridge::PatchJets other(second.rounded);
  const std::array<double, 2> here{tip.side[0] > 0 ? 1.0 : 0.0, tip.side[1] > 0 ? 1.0 : 0.0};
  const std::array<double, 2> there = nearest_parameters(other, own.at(here[0], here[1]).point);
  const auto parameters = located(second, tip.point, there);
  if (!parameters) return std::nullopt;
  const Vector3d way = mean(second.exact) - rounded(tip.point);
  if (!are_separated(first.exact, tip, second.exact, way, normal_at(second.rounded, there))) return std::nullopt;
  CommonPoint result;
  for (std::size_t k = 0; k < 2; ++k) {
    if (tip.side[k] != 0) result.parameters[k] = Rational(tip.side[k] < 0 ? 0 : 1);
    result.parameters[2 + k] = (*parameters)[k];
  }
  return result;
}

/// Both end in one point.
std::optional<CommonPoint> at_both_tips(const ExactNet& first, const Tip& a, const ExactNet& second, const Tip& b) {
  const Vector3d into_second = mean_at(second, b, 1) - rounded(b.point);
  const Vector3d into_first = mean_at(first, a, 1) - rounded(a.point);
  const Vector3d none = Vector3d::Zero();
  if (!are_separated(first, a, second, into_second, none) && !are_separated(second, b, first, into_first, none))
    return std::nullopt;
  CommonPoint result;
  for (std::size_t k = 0; k < 2; ++k) {
    if (a.side[k] != 0) result.parameters[k] = Rational(a.side[k] < 0 ? 0 : 1);
    if (b.side[k] != 0) result.parameters[2 + k] = Rational(b.side[k] < 0 ? 0 : 1);
  }
  return result;
}

CommonPoint exchanged(CommonPoint point) {
  std::swap(point.parameters[0], point.parameters[2]);
  std::swap(point.parameters[1], point.parameters[3]);
  return point;
}

bool is_border(const Tip& tip) { return tip.side[0] == 0 || tip.side[1] == 0; }

}  // namespace

bool is_one_point(const ExactNet& net, std::size_t axis, int side) {
  const std::size_t kept = side < 0 ? 0 : net.degrees[axis];
  const auto at = [&](std::size_t i) { return axis == 0 ? index_of(net, kept, i) : index_of(net, i, kept); };
  for (std::size_t i = 1; i <= net.degrees[1 - axis]; ++i)
    if (!are_equal(net.points[at(0)], net.points[at(i)])) return false;
  return true;
}

std::array<int, 4> CommonPoint::side() const {
  std::array<int, 4> result{};
  for (std::size_t k = 0; k < 4; ++k)
    if (parameters[k]) result[k] = parameters[k]->is_zero() ? -1 : *parameters[k] == Rational(1) ? 1 : 0;
  return result;
}

std::optional<CommonPoint> only_common_point(const PatchNets& first, const PatchNets& second) {
  const std::vector<Tip> own = tips_of(first.exact);
  const std::vector<Tip> others = tips_of(second.exact);
  const Tip* a = nullptr;
  const Tip* b = nullptr;
  for (const Tip& tip : own)
    for (const Tip& other : others) {
      if (!are_equal(tip.point, other.point)) continue;
      if (a != nullptr) return std::nullopt;
      a = &tip;
      b = &other;
    }
  if (a != nullptr) return at_both_tips(first.exact, *a, second.exact, *b);
  for (const Tip& tip : own)
    if (is_border(tip))
      if (auto point = at_tip(first, tip, second)) return point;
  for (const Tip& tip : others)
    if (is_border(tip))
      if (auto point = at_tip(second, tip, first)) return exchanged(*std::move(point));
  return std::nullopt;
}

}  // namespace eliminant::intersect
