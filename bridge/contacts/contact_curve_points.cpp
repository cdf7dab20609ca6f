// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/contact_curve_points.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/QR>
#include <Eigen/SVD>

#include <eliminant/bridge/contacts/contact_conditions.hpp>

namespace eliminant::bridge {

namespace {

using Eigen::Vector4d;

/// How far the curve is followed beyond the domains.
constexpr double beyond = 0.02;

struct CurvePoint {
  Vector4d at;
  Vector4d tangent;
  /// The least singular value across the curve, relative to the largest one.
  double condition = 0;
};

class Following {
 public:
  Following(const ControlNet& first, const ControlNet& second) : first_(first), second_(second) {
    for (const ControlNet* net : {&first, &second})
      for (const Array4d& point : net->points) size_ = std::max(size_, point.head<3>().abs().maxCoeff());
  }

  /// Newton's method with the least of all steps.
  std::optional<CurvePoint> on_curve(Vector4d x, double reach) {
    const Vector4d start = x;
    constexpr int most_steps = 12;
    for (int step = 0; step < most_steps; ++step) {
      ContactConditions here = contact_conditions(first_, second_, x);
      const double largest = here.jacobian.topRows<2>().lpNorm<Eigen::Infinity>();
      for (long row = 0; row < 4; ++row) {
        const double size = here.jacobian.row(row).lpNorm<Eigen::Infinity>();
        // Along a line in both surfaces the tangent planes say nothing: what there is of that condition is rounding.
        constexpr double void_condition = 1e-11;
        if (!(size > (row < 2 ? void_condition * largest : 0))) {
          here.jacobian.row(row).setZero();
          here.value[row] = 0;
          continue;
        }
        here.jacobian.row(row) /= size;
        here.value[row] /= size;
      }
      if (!here.jacobian.allFinite() || !here.value.allFinite()) return std::nullopt;
      const Eigen::JacobiSVD<Eigen::Matrix4d> svd(here.jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
      const Vector4d sizes = svd.singularValues();
      constexpr double singular = 1e-5;
      if (!(sizes[2] > singular * sizes[0])) return std::nullopt;
      const Vector4d components = svd.matrixU().transpose() * here.value;
      Vector4d change = Vector4d::Zero();
      for (long k = 0; k < 3; ++k) change += svd.matrixV().col(k) * (components[k] / sizes[k]);
      x -= change;
      if (!((x - start).lpNorm<Eigen::Infinity>() < reach)) return std::nullopt;
      if (change.lpNorm<Eigen::Infinity>() > at_rest) continue;
      // A contact on its own has a regular matrix; parallel tangent planes may be apart.
      constexpr double in_kernel = 1e-6;
      if (!(sizes[3] < in_kernel * sizes[0]) || !(here.value.lpNorm<Eigen::Infinity>() < 1e-11)) return std::nullopt;
      if (!(std::fabs(here.gap) < 1e-10 * size_)) return std::nullopt;
      return CurvePoint{x, svd.matrixV().col(3), sizes[2] / sizes[0]};
    }
    return std::nullopt;
  }

  /// Points in both directions, about `step` apart.
  std::vector<std::array<double, 4>> points_from(const CurvePoint& start, double step) {
    std::vector<std::array<double, 4>> points;
    add(start, points);
    for (const double direction : {1.0, -1.0}) {
      CurvePoint here = start;
      here.tangent *= direction;
      constexpr int most_points = 160;
      for (int i = 0; i < most_points; ++i) {
        // Over a point at which a branch crosses the curve.
        std::optional<CurvePoint> next;
        for (double ahead = step; !next && ahead < 4 * step; ahead += step)
          next = on_curve(here.at + ahead * here.tangent, 0.5 * ahead);
        if (!next || !is_inside(next->at)) break;
        if (next->tangent.dot(here.tangent) < 0) next->tangent = -next->tangent;
        here = *next;
        if (i > 2 && (here.at - start.at).norm() < step) return points;
        add(here, points);
      }
    }
    return points;
  }

 private:
  static constexpr double at_rest = 1e-12;

  static bool is_inside(const Vector4d& x) { return x.minCoeff() > -beyond && x.maxCoeff() < 1 + beyond; }

  static void add(const CurvePoint& point, std::vector<std::array<double, 4>>& points) {
    constexpr double poor = 1e-3;
    if (!(point.condition > poor)) return;
    points.push_back({point.at[0], point.at[1], point.at[2], point.at[3]});
  }

  PatchJets first_;
  PatchJets second_;
  double size_ = 0;
};

}  // namespace

std::optional<std::array<double, 4>> contact_curve_point(const ControlNet& first, const ControlNet& second,
                                                         const std::array<double, 4>& near, double reach) {
  const auto found = Following(first, second).on_curve({near[0], near[1], near[2], near[3]}, reach);
  if (!found) return std::nullopt;
  return std::array<double, 4>{found->at[0], found->at[1], found->at[2], found->at[3]};
}

std::vector<std::array<double, 4>> contact_curve_points(const ControlNet& first, const ControlNet& second,
                                                        const std::array<double, 4>& on_curve) {
  Following following(first, second);
  constexpr double rounding = 1e-9;
  const auto start = following.on_curve({on_curve[0], on_curve[1], on_curve[2], on_curve[3]}, rounding);
  if (!start) return {};
  constexpr std::size_t enough = 24;
  constexpr double first_step = 0x1p-5;
  constexpr double least_step = 0x1p-12;
  std::vector<std::array<double, 4>> points;
  for (double step = first_step; step >= least_step && points.size() < enough; step *= 0.25)
    points = following.points_from(*start, step);
  if (points.size() < enough) return {};
  return points;
}

namespace {

/// The parameters of the point of a patch that is nearest to another one, by Newton's method for least squares.
std::optional<std::array<double, 2>> foot_on(PatchJets& patch, const Array4d& point, std::array<double, 2> at) {
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const PatchJets::Value here = patch.at(at[0], at[1]);
    Eigen::Matrix<double, 3, 2> jacobian;
    for (long k = 0; k < 2; ++k) jacobian.col(k) = here.first[static_cast<std::size_t>(k)].head<3>().matrix();
    const Eigen::Vector3d apart = (point - here.point).head<3>().matrix();
    const Eigen::Vector2d change = jacobian.colPivHouseholderQr().solve(apart);
    if (!change.allFinite()) return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k) at[k] = std::clamp(at[k] + change[static_cast<long>(k)], -beyond, 1 + beyond);
    if (change.lpNorm<Eigen::Infinity>() < 1e-14) break;
  }
  const PatchJets::Value here = patch.at(at[0], at[1]);
  constexpr double many = 64;
  if (!((point - here.point).abs().head<3>().maxCoeff() < many * here.error)) return std::nullopt;
  return at;
}

}  // namespace

std::vector<std::array<double, 4>> points_along_border(const ControlNet& first, const ControlNet& second,
                                                       const ContainedBorder& border) {
  const bool of_first = border.axis < 2;
  PatchJets own(of_first ? first : second);
  PatchJets other(of_first ? second : first);
  const std::size_t base = of_first ? 0 : 2;
  constexpr int count = 40;
  constexpr int grid = 4;
  std::optional<std::array<double, 2>> foot;
  std::vector<std::array<double, 4>> points;
  for (int i = 0; i <= count; ++i) {
    std::array<double, 4> at{};
    at[border.axis] = border.side < 0 ? 0 : 1;
    at[of_first ? 1 - border.axis : 5 - border.axis] =
        border.lower + (border.upper - border.lower) * static_cast<double>(i) / count;
    const Array4d point = own.at(at[base], at[base + 1]).point;
    if (foot) foot = foot_on(other, point, *foot);
    for (int start = 0; !foot && start < grid * grid; ++start) {
      const int row = start / grid;
      foot = foot_on(other, point, {(start % grid + 0.5) / grid, (row + 0.5) / grid});
    }
    if (!foot) return {};
    at[2 - base] = (*foot)[0];
    at[3 - base] = (*foot)[1];
    points.push_back(at);
  }
  return points;
}

}  // namespace eliminant::bridge
