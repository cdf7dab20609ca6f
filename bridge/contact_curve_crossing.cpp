// SPDX-License-Identifier: BSD-3-Clause
//
// Where a branch crosses a curve of contact.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <eliminant/bridge/contact_curve.hpp>
#include <eliminant/bridge/contact_curve_internal.hpp>
#include <eliminant/bridge/enclosed_patch.hpp>

namespace eliminant::bridge {

using namespace contact;

std::optional<ContactCurve::Tables> ContactCurve::tables_near(const Place& at, std::size_t order) const {
  const auto frame = tangent_frame(PatchJets(base_).at(at[0], at[1]));
  if (!frame) return std::nullopt;
  const Place there{numerator_[0].near(at[0], at[1]) / denominator_[0].near(at[0], at[1]),
                    numerator_[1].near(at[0], at[1]) / denominator_[1].near(at[0], at[1])};
  Tables tables{taylor_near(base_, at[0], at[1], order), taylor_near(other_, there[0], there[1], order),
                base_.polynomial && other_.polynomial};
  to_frame(*frame, tables.base);
  to_frame(*frame, tables.other);
  return tables;
}

std::optional<PlaneSeries<double>> ContactCurve::heights_near(const Place& at, std::size_t order) const {
  const auto tables = tables_near(at, order);
  if (!tables) return std::nullopt;
  return tables->heights({1, 0}, {0, 1}, order);
}

std::optional<Place> ContactCurve::crossing_near(const Place& start, double reach) const {
  // The secant method along the curve.
  const auto bend_at = [&](const Place& at) {
    const auto heights = heights_near(at, 2);
    return heights ? derivative_in(*heights, unit(gradient(at)), 2) : std::nan("");
  };
  const auto moved = [&](const Place& at, double by) {
    const Place across = unit(gradient(at));
    return nearest({at[0] - by * across[1], at[1] + by * across[0]});
  };
  Place here = start;
  double bend = bend_at(here);
  double step = 0.125 * reach;
  constexpr int most_steps = 25;
  for (int i = 0; i < most_steps; ++i) {
    const Place next = moved(here, step);
    const double next_bend = bend_at(next);
    const double slope = (next_bend - bend) / step;
    if (!std::isfinite(slope) || slope == 0) return std::nullopt;
    if (!(std::hypot(next[0] - start[0], next[1] - start[1]) < reach)) return std::nullopt;
    here = next;
    bend = next_bend;
    step = -bend / slope;
    if (!(std::fabs(step) < reach)) return std::nullopt;
    if (std::fabs(step) < 1e-13) return here;
  }
  return std::fabs(step) < 1e-9 ? std::optional(here) : std::nullopt;
}

std::optional<CurveCrossing> ContactCurve::crossing(const CellBox& asked) const {
  const CellBox box = in_base_order(asked);
  const Place middle{0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])};
  const double size = std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
  const Place start = nearest(middle);
  if (!(std::hypot(start[0] - middle[0], start[1] - middle[1]) < 2 * size)) return std::nullopt;
  const auto found = crossing_near(start, 4 * size);
  if (!found) return std::nullopt;
  const Place origin = *found;
  const Place steepest = unit(gradient(origin));
  const Place along{-steepest[1], steepest[0]};
  // Across the curve and the branch alike.
  const auto heights_here = heights_near(origin, 3);
  if (!heights_here) return std::nullopt;
  Place across = steepest;
  double largest = 0;
  for (const double turn : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    const Place direction{std::cos(turn) * steepest[0] + std::sin(turn) * along[0],
                          std::cos(turn) * steepest[1] + std::sin(turn) * along[1]};
    const double third = std::fabs(derivative_in(*heights_here, direction, 3));
    if (third > largest * 1.25) {
      largest = third;
      across = direction;
    }
  }
  const auto around = region(box, origin, across, along, 4);
  if (!around) return std::nullopt;
  const Forms forms = forms_on(*around, around->heights(4));
  if (!forms.xxx.is_finite() || !forms.xxx.excludes_zero()) return std::nullopt;
  const DoubleInterval turning = forms.xxy + forms.xxx * around->slope;
  if (!turning.is_finite() || !turning.excludes_zero()) return std::nullopt;

  // Newton's step from the origin, where h is known to roundings.
  const double bend = std::fabs(derivative_in(*heights_here, across, 2)) + rounding_of_derivative(2);
  const double least = std::min(std::fabs(turning.lower), std::fabs(turning.upper));
  const double shift = bend / least + 1e-14;
  if (!(shift < 0.5 * around->length)) return std::nullopt;
  CurveCrossing result;
  result.parameters = parameters_at(origin);
  const double moved = shift * (1 + around->slope.magnitude());
  result.radius = moved * (1 + around->following);
  bool outside = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const double at = result.parameters[k];
    result.inside = result.inside && at - result.radius > asked.lower[k] && at + result.radius < asked.upper[k];
    outside = outside || at + result.radius < asked.lower[k] || at - result.radius > asked.upper[k];
  }
  if (!result.inside && !outside) return std::nullopt;
  const double area = cross(across, along);
  const std::size_t first = swapped_ ? 2 : 0;
  result.growing[first] = -across[1] / area;
  result.growing[first + 1] = across[0] / area;

  result.origin = origin;
  result.across = across;
  result.along = along;
  result.reach = around->reach;
  result.length = around->length;
  result.least_third = std::min(std::fabs(forms.xxx.lower), std::fabs(forms.xxx.upper));
  // The offset of the branch from the curve is where the divided difference vanishes, an average of second derivatives.
  const DoubleInterval offset_slope = -(DoubleInterval(3) * turning) / forms.xxx;
  const DoubleInterval moving_third = forms.xxxy + around->slope * forms.xxxx;
  const DoubleInterval turning_twice = forms.xxyy + DoubleInterval(2) * around->slope * forms.xxxy +
                                       around->slope * around->slope * forms.xxxx + around->bend * forms.xxx;
  const DoubleInterval offset_bend =
      -(DoubleInterval(3) * turning_twice + DoubleInterval(2) * moving_third * offset_slope +
        DoubleInterval(0.5) * forms.xxxx * offset_slope * offset_slope) /
      forms.xxx;
  result.branch_slope = (around->slope + offset_slope).magnitude();
  result.branch_bend = (around->bend + offset_bend).magnitude();
  // In a smaller box more is known of the branch.
  double extent = 0;
  for (const Array4d& point : base_.points) extent = std::max(extent, point.abs().head<3>().maxCoeff());
  constexpr double accuracy = 1e-6;
  constexpr double pieces = 512;
  if (!(chord_error(result, result.length / pieces, 0) < accuracy * extent)) return std::nullopt;
  return result;
}

std::optional<BranchPoint> ContactCurve::branch_point(const CurveCrossing& crossing, double x, double y) const {
  const auto place = [&](double across) {
    return Place{crossing.origin[0] + across * crossing.across[0] + y * crossing.along[0],
                 crossing.origin[1] + across * crossing.across[1] + y * crossing.along[1]};
  };
  PatchJets base(base_);
  PatchJets other(other_);
  const auto frame = tangent_frame(base.at(crossing.origin[0], crossing.origin[1]));
  if (!frame) return std::nullopt;
  // The curve at y.
  double on_curve = 0;
  for (int step = 0; step < 8; ++step) {
    const Place at = place(on_curve);
    on_curve -= curve_.near(at[0], at[1]) / dot(gradient(at), crossing.across);
  }
  const auto in_frame = [&](const Array4d& d) {
    return Array4d(frame->columns[0] * d[0] + frame->columns[1] * d[1] + frame->columns[2] * d[2]);
  };
  BranchPoint result;
  double residual = 0;
  double slack = 0;
  // The difference of the patches along the normal, once they are equal along the plane.
  const auto difference_at = [&](double across) {
    const Place at = place(across);
    const PatchJets::Value a = base.at(at[0], at[1]);
    std::array<double, 4> both = parameters_at(at);
    if (swapped_) both = {both[2], both[3], both[0], both[1]};
    PatchJets::Value b = other.at(both[2], both[3]);
    Array4d difference = in_frame(a.point - b.point);
    for (int step = 0; step < 5; ++step) {
      const auto by_plane = parameters_by_plane(*frame, b);
      if (!by_plane) break;
      const Eigen::Vector2d change = *by_plane * Eigen::Vector2d(difference[0], difference[1]);
      both[2] += change[0];
      both[3] += change[1];
      b = other.at(both[2], both[3]);
      difference = in_frame(a.point - b.point);
      if (!(change.lpNorm<Eigen::Infinity>() > 1e-14)) break;
    }
    for (std::size_t k = 0; k < 3; ++k) result.point[k] = a.point[static_cast<long>(k)];
    result.parameters = swapped_ ? std::array<double, 4>{both[2], both[3], at[0], at[1]} : both;
    residual = difference[2];
    slack = 4 * (a.error + b.error);
    return residual / ((across - on_curve) * (across - on_curve));
  };
  // The secant method on the divided difference, which is nearly linear.
  double before = x + 0.01 * (x - on_curve);
  double before_value = difference_at(before);
  double here = x;
  double value = difference_at(here);
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps && value != before_value; ++step) {
    const double next = here - value * (here - before) / (value - before_value);
    if (!(std::fabs(next) < 2 * crossing.reach) || next == on_curve) return std::nullopt;
    before = std::exchange(here, next);
    before_value = std::exchange(value, difference_at(next));
    if (std::fabs(here - before) < 1e-12) break;
  }
  double heaviest = 1;
  for (const ControlNet* net : {&base_, &other_}) {
    double most = 0;
    for (const Array4d& point : net->points) most = std::max(most, point[3]);
    heaviest *= most;
  }
  const double offset = std::fabs(here - on_curve) * (1 - 1e-6) - 1e-13;
  if (!(offset > 0) || !(std::fabs(here) < crossing.reach)) return std::nullopt;
  result.error = 6.1 * heaviest * (std::fabs(residual) + slack) / (crossing.least_third * offset * offset) + 1e-15;
  return result;
}

double ContactCurve::chord_error(const CurveCrossing& crossing, double step, double error) const {
  const double half = crossing.reach + crossing.length;
  const Place& origin = crossing.origin;
  const auto bounds =
      PatchJets(base_).bounds_on(origin[0] - half, origin[0] + half, origin[1] - half, origin[1] + half);
  if (!bounds) return std::numeric_limits<double>::infinity();
  const double length = step * (1 + crossing.branch_slope);
  const double deviation = 0.125 * crossing.branch_bend * step * step + error;
  double result = 0;
  for (long c = 0; c < 3; ++c) {
    const double speed = bounds->first[0][c] + bounds->first[1][c];
    const double bending = bounds->second[0][c] + 2 * bounds->second[1][c] + bounds->second[2][c];
    result = std::max(result, speed * deviation + 0.125 * bending * length * length);
  }
  return 1.74 * result;
}

}  // namespace eliminant::bridge
