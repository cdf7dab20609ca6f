// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/crossing_branch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/contacts/contact_curve_internal.hpp>

namespace eliminant::bridge {

using namespace contact;

namespace {

/// Heights are of the third order in distances down to 1e-6, and wanted to eleven digits.
constexpr long bits = 160;

RealBall ball_of(double value) {
  RealBall result;
  arb_set_d(result.get(), value);
  return result;
}

double middle_of(const RealBall& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

double radius_of(const RealBall& x) { return mag_get_d(arb_radref(x.get())); }

double magnitude_of(const RealBall& x) { return std::fabs(middle_of(x)) * (1 + 0x1p-50) + radius_of(x); }

double heaviest_of(const ControlNet& net) {
  double most = 0;
  for (const Array4d& point : net.points) most = std::max(most, point[3] + net.error[3]);
  return most;
}

/// The difference of two points in the directions of a frame.
std::array<RealBall, 3> in_frame(const ContactFrame& frame, const std::array<RealBall, 3>& a,
                                 const std::array<RealBall, 3>& b) {
  std::array<RealBall, 3> result;
  RealBall difference;
  for (std::size_t k = 0; k < 3; ++k) {
    arb_sub(difference.get(), a[k].get(), b[k].get(), bits);
    for (std::size_t r = 0; r < 3; ++r)
      arb_addmul(result[r].get(), difference.get(), ball_of(frame.columns[k][static_cast<long>(r)]).get(), bits);
  }
  return result;
}

}  // namespace

CrossingBranch::CrossingBranch(const ContactCurve& curve, const CurveCrossing& crossing)
    : curve_(curve),
      crossing_(crossing),
      base_(curve.base()),
      other_(curve.other()),
      ball_base_(curve.exact_base(), bits),
      ball_other_(curve.exact_other(), bits),
      heaviest_(heaviest_of(curve.base()) * heaviest_of(curve.other())) {
  frame_ = tangent_frame(base_.at(crossing.origin[0], crossing.origin[1]));
}

std::optional<CrossingBranch::Quotient> CrossingBranch::quotient_at(double x, double on_curve, BranchPoint& point) {
  Place at;
  for (std::size_t k = 0; k < 2; ++k)
    at[k] = crossing_.origin[k] + x * crossing_.across[k] + point.y * crossing_.along[k];
  const PatchJets::Value a = base_.at(at[0], at[1]);
  for (std::size_t k = 0; k < 3; ++k) point.point[k] = a.point[static_cast<long>(k)];
  // The parameters of the other patch, by Newton's method: in doubles, and one step in balls.
  std::array<double, 4> both = curve_.parameters_at(at);
  if (curve_.swapped()) both = {both[2], both[3], both[0], both[1]};
  std::optional<Eigen::Matrix2d> by_plane;
  PatchJets::Value b;
  constexpr int most_steps = 6;
  for (int step = 0; step < most_steps; ++step) {
    b = other_.at(both[2], both[3]);
    by_plane = parameters_by_plane(*frame_, b);
    if (!by_plane) return std::nullopt;
    const Array4d apart = a.point - b.point;
    const Array4d d = frame_->columns[0] * apart[0] + frame_->columns[1] * apart[1] + frame_->columns[2] * apart[2];
    const Eigen::Vector2d change = *by_plane * Eigen::Vector2d(d[0], d[1]);
    both[2] += change[0];
    both[3] += change[1];
    if (!(change.lpNorm<Eigen::Infinity>() > 1e-9)) break;
  }
  point.parameters = curve_.swapped() ? std::array<double, 4>{both[2], both[3], at[0], at[1]}
                                      : std::array<double, 4>{at[0], at[1], both[2], both[3]};
  const std::array<RealBall, 3> ball_a = ball_base_.point_at(ball_of(at[0]), ball_of(at[1]));
  std::array<RealBall, 2> there{ball_of(both[2]), ball_of(both[3])};
  std::array<RealBall, 3> difference;
  constexpr int ball_steps = 2;
  for (int step = 0; step <= ball_steps; ++step) {
    difference = in_frame(*frame_, ball_a, ball_other_.point_at(there[0], there[1]));
    if (step == ball_steps) break;
    for (long row = 0; row < 2; ++row) {
      RealBall& parameter = there[static_cast<std::size_t>(row)];
      for (long k = 0; k < 2; ++k)
        arb_addmul(parameter.get(), difference[static_cast<std::size_t>(k)].get(), ball_of((*by_plane)(row, k)).get(),
                   bits);
      arb_get_mid_arb(parameter.get(), parameter.get());
    }
  }
  // What is left of the difference along the plane moves the height by the inclination of the other patch.
  double inclination = 1;
  for (const Array4d& d : b.first)
    inclination +=
        std::fabs(d[0] * frame_->columns[0][2] + d[1] * frame_->columns[1][2] + d[2] * frame_->columns[2][2]);
  const double steps = by_plane->lpNorm<1>() * (magnitude_of(difference[0]) + magnitude_of(difference[1]));
  const double offset = x - on_curve;
  Quotient result;
  result.value = middle_of(difference[2]) / (offset * offset);
  result.error = (radius_of(difference[2]) + 2 * inclination * steps) / (offset * offset);
  return result;
}

std::optional<BranchPoint> CrossingBranch::at(double x, double y, double accuracy) {
  if (!frame_) return std::nullopt;
  const double on_curve = curve_.across_at(crossing_, y);
  BranchPoint point;
  point.y = y;
  constexpr int most_steps = 12;
  double before = 0;
  std::optional<Quotient> last;
  for (int step = 0; step < most_steps; ++step) {
    if (!(std::fabs(x) < crossing_.reach) || x == on_curve) return std::nullopt;
    const auto here = quotient_at(x, on_curve, point);
    if (!here) return std::nullopt;
    // The distance from the curve is rounded.
    constexpr double rounding = 1e-15;
    const double relative = 1 + 4 * rounding / std::fabs(x - on_curve);
    point.x = x;
    point.error =
        6.1 * heaviest_ * relative * (std::fabs(here->value) + here->error) / crossing_.least_third + rounding;
    if (point.error < accuracy && relative < 1.01) return point;
    if (last && x != before) slope_ = (here->value - last->value) / (x - before);
    const double slope = slope_ != 0 ? slope_ : 0;
    last = here;
    before = x;
    // The secant method on the quotient, which is nearly linear.
    const double shift = slope != 0 ? -here->value / slope : 0.01 * (x - on_curve);
    x += shift;
    if (!std::isfinite(x)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace eliminant::bridge
