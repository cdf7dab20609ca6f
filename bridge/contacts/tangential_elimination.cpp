// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/tangential_elimination.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <eliminant/bridge/nets/patch_jets.hpp>

namespace eliminant::bridge {

namespace {

double along_plane(const ContactFrame& frame, const Array4d& d, long row) {
  return d[0] * frame.columns[0][row] + d[1] * frame.columns[1][row] + d[2] * frame.columns[2][row];
}

/// The parameters of the second patch at which its coordinates along the tangent plane of the first are those of the
/// origin of the frame, approximately.
std::optional<std::array<double, 2>> opposite(PatchJets& second, const ContactFrame& frame, std::array<double, 2> at) {
  constexpr int most_steps = 12;
  double step = INFINITY;
  for (int i = 0; i < most_steps && step > 1e-15; ++i) {
    // Control points tell little far beyond the domain.
    constexpr double beyond = 0.02;
    for (const double x : at)
      if (!(x > -beyond && x < 1 + beyond)) return std::nullopt;
    const PatchJets::Value value = second.at(at[0], at[1]);
    Eigen::Matrix2d derivative;
    Eigen::Vector2d rest;
    for (long row = 0; row < 2; ++row) {
      rest[row] = along_plane(frame, value.point - frame.origin, row);
      for (long k = 0; k < 2; ++k)
        derivative(row, k) = along_plane(frame, value.first[static_cast<std::size_t>(k)], row);
    }
    const Eigen::Vector2d change = derivative.partialPivLu().solve(rest);
    if (!change.allFinite()) return std::nullopt;
    at = {at[0] - change[0], at[1] - change[1]};
    step = change.lpNorm<Eigen::Infinity>();
  }
  if (!(step < 1e-9)) return std::nullopt;
  return at;
}

/// The function h and its derivatives at one point, without bounds.
struct Height {
  double value;
  std::array<double, 2> gradient;
  double uu;
  double uv;
  double vv;
};

/// Where both patches have the same coordinates along the plane.
std::optional<Height> height_at(const ContactFrame& frame, const PatchJets::Value& a, const PatchJets::Value& b) {
  Eigen::Matrix2d derivative;
  for (long row = 0; row < 2; ++row)
    for (long k = 0; k < 2; ++k) derivative(row, k) = along_plane(frame, b.first[static_cast<std::size_t>(k)], row);
  const Eigen::Matrix2d follow = derivative.inverse();
  if (!follow.allFinite()) return std::nullopt;
  // The normal of the second patch with its last component 1; the first patch has unit slopes along the plane.
  Eigen::Vector3d normal(0, 0, 1);
  for (long i = 0; i < 2; ++i)
    normal[i] = -(along_plane(frame, b.first[0], 2) * follow(0, i) + along_plane(frame, b.first[1], 2) * follow(1, i));
  const auto bend = [&](long i, long j) {
    const Array4d bend_of_second = b.second[0] * (follow(0, i) * follow(0, j)) +
                                   b.second[1] * (follow(0, i) * follow(1, j) + follow(1, i) * follow(0, j)) +
                                   b.second[2] * (follow(1, i) * follow(1, j));
    const Array4d difference = a.second[static_cast<std::size_t>(i + j)] - bend_of_second;
    double sum = 0;
    for (long c = 0; c < 3; ++c) sum += normal[c] * along_plane(frame, difference, c);
    return sum;
  };
  return Height{along_plane(frame, a.point - b.point, 2), {normal[0], normal[1]}, bend(0, 0), bend(0, 1), bend(1, 1)};
}

/// Whether the proof of `keep_distance` has a chance: its bounds, from the values at the centre alone.
bool may_keep_distance(const Height& height, const std::array<double, 2>& reach) {
  const auto& [p, q] = reach;
  const double least = std::fabs(height.value);
  const double most =
      std::fabs(height.gradient[0]) * p + std::fabs(height.gradient[1]) * q +
      0.5 * (std::fabs(height.uu) * p * p + 2 * std::fabs(height.uv) * p * q + std::fabs(height.vv) * q * q);
  const double sign = height.value > 0 ? 1 : -1;
  const double curvature = std::min(sign * height.uu, sign * height.vv) - std::fabs(height.uv);
  const double slope = std::hypot(height.gradient[0], height.gradient[1]);
  return least > most || least * curvature > 0.5 * slope * slope;
}

}  // namespace

DoubleInterval Hessian::form(const std::array<double, 2>& a, const std::array<double, 2>& b) const {
  return uu * DoubleInterval(a[0] * b[0]) + uv * DoubleInterval(a[0] * b[1] + a[1] * b[0]) +
         vv * DoubleInterval(a[1] * b[1]);
}

std::optional<TangentialElimination> TangentialElimination::on(const ControlNet& first, const ControlNet& second,
                                                               const std::array<double, 4>& centre,
                                                               const CellBox& box) {
  const PatchJets::Value a0 = PatchJets(first).at(centre[0], centre[1]);
  const PatchJets::Value b0 = PatchJets(second).at(centre[2], centre[3]);
  const auto frame = tangent_frame(a0);
  if (!frame) return std::nullopt;
  const EnclosedPatch a(
      taylor_on_box(first, *frame, {{box.lower[0], box.lower[1], 0}, {box.upper[0], box.upper[1], 0}}, 0, 2));
  // The parameters (s, t) by (u, v), to first order: the inverse of the derivative along the tangent plane.
  Eigen::Matrix2d derivative;
  for (long row = 0; row < 2; ++row)
    for (long k = 0; k < 2; ++k) derivative(row, k) = along_plane(*frame, b0.first[static_cast<std::size_t>(k)], row);
  const Eigen::Matrix2d inverse = derivative.inverse();
  if (!inverse.allFinite()) return std::nullopt;
  // A box for (s, t) that holds the cell and all values of that function.
  const double extent_u = a.value[0].magnitude();
  const double extent_v = a.value[1].magnitude();
  // With a contraction of 0.3 in the larger of both coordinates.
  const double mixed = 0.44 * std::max(extent_u, extent_v);
  OpenBox of_second{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto row = static_cast<long>(k);
    constexpr double room = 1.1;
    const double half =
        room * (std::fabs(inverse(row, 0)) * (extent_u + mixed) + std::fabs(inverse(row, 1)) * (extent_v + mixed));
    of_second.lower[k] = std::min(box.lower[2 + k], centre[2 + k] - half);
    of_second.upper[k] = std::max(box.upper[2 + k], centre[2 + k] + half);
    // Control points tell little far beyond the domain.
    constexpr double beyond = 0.25;
    if (of_second.lower[k] < -beyond || of_second.upper[k] > 1 + beyond) return std::nullopt;
  }
  const EnclosedPatch b(taylor_on_box(second, *frame, of_second, 0, 2));

  // In parameters of the second in which its derivative along the plane is near the identity.
  std::array<EnclosedPatch::Point, 2> slope;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t c = 0; c < 3; ++c)
      slope[k][c] = b.first[0][c] * DoubleInterval(inverse(0, static_cast<long>(k))) +
                    b.first[1][c] * DoubleInterval(inverse(1, static_cast<long>(k)));
  double contraction = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) sum += (slope[k][c] - DoubleInterval(c == k ? 1 : 0)).magnitude();
    contraction = std::max(contraction, sum);
  }
  constexpr double at_most = 0.3;
  if (!(contraction < at_most)) return std::nullopt;
  const DoubleInterval determinant = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
  const std::array<std::array<DoubleInterval, 2>, 2> solve{{{slope[1][1] / determinant, -slope[1][0] / determinant},
                                                            {-slope[0][1] / determinant, slope[0][0] / determinant}}};
  // The normal of the second with its last component 1.
  const std::array<DoubleInterval, 3> normal{-(slope[0][2] * solve[0][0] + slope[1][2] * solve[1][0]),
                                             -(slope[0][2] * solve[0][1] + slope[1][2] * solve[1][1]),
                                             DoubleInterval(1)};
  // How (s, t) follow u and v.
  std::array<std::array<DoubleInterval, 2>, 2> follow;
  for (std::size_t i = 0; i < 2; ++i) {
    const DoubleInterval p = solve[0][0] * a.first[i][0] + solve[0][1] * a.first[i][1];
    const DoubleInterval q = solve[1][0] * a.first[i][0] + solve[1][1] * a.first[i][1];
    for (std::size_t k = 0; k < 2; ++k)
      follow[i][k] =
          DoubleInterval(inverse(static_cast<long>(k), 0)) * p + DoubleInterval(inverse(static_cast<long>(k), 1)) * q;
  }
  const auto entry = [&](std::size_t i, std::size_t j) {
    DoubleInterval sum(0);
    for (std::size_t c = 0; c < 3; ++c) {
      const DoubleInterval bend = b.second[0][c] * follow[i][0] * follow[j][0] +
                                  b.second[1][c] * (follow[i][0] * follow[j][1] + follow[i][1] * follow[j][0]) +
                                  b.second[2][c] * follow[i][1] * follow[j][1];
      sum = sum + normal[c] * (a.second[i + j][c] - bend);
    }
    return sum;
  };
  TangentialElimination result{*frame, a, b, {}, contraction, {}, {entry(0, 0), entry(0, 1), entry(1, 1)}};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto row = static_cast<long>(i);
    result.inverse[i] = {inverse(row, 0), inverse(row, 1)};
    for (std::size_t c = 0; c < 3; ++c) result.gradient[i] = result.gradient[i] + normal[c] * a.first[i][c];
  }
  return result;
}

bool keep_distance(const ControlNet& first, const ControlNet& second, const CellBox& box) {
  std::array<double, 4> centre{};
  for (std::size_t k = 0; k < 4; ++k) centre[k] = 0.5 * (box.lower[k] + box.upper[k]);
  const PatchJets::Value value = PatchJets(first).at(centre[0], centre[1]);
  const auto frame = tangent_frame(value);
  if (!frame) return false;
  PatchJets jets(second);
  const auto across = opposite(jets, *frame, {centre[2], centre[3]});
  if (!across) return false;
  centre = {centre[0], centre[1], (*across)[0], (*across)[1]};
  CellBox whole = box;
  CellBox middle;
  for (std::size_t k = 0; k < 4; ++k) {
    // It holds the true values of the function, which are near; derivatives on much smaller boxes are all rounding.
    constexpr double near = 0x1p-22;
    middle.lower[k] = centre[k] - near;
    middle.upper[k] = centre[k] + near;
    whole.lower[k] = std::min(whole.lower[k], middle.lower[k]);
    whole.upper[k] = std::max(whole.upper[k], middle.upper[k]);
  }
  const std::array<double, 2> reach{std::max(whole.upper[0] - centre[0], centre[0] - whole.lower[0]),
                                    std::max(whole.upper[1] - centre[1], centre[1] - whole.lower[1])};
  const auto height_here = height_at(*frame, value, jets.at(centre[2], centre[3]));
  if (!height_here || !may_keep_distance(*height_here, reach)) return false;
  const auto here = TangentialElimination::on(first, second, centre, middle);
  if (!here) return false;
  const auto around = TangentialElimination::on(first, second, centre, whole);
  if (!around) return false;
  // h at a point of the first patch at most that far from the centre: the coordinates along the plane agree where the
  // second patch has those of the first there.
  const DoubleInterval height = here->first.value[2] - here->second.value[2];
  double most = 0;
  for (std::size_t i = 0; i < 2; ++i) most += here->gradient[i].magnitude() * reach[i];
  const Hessian& h = around->hessian;
  most += 0.5 * (h.uu.magnitude() * reach[0] * reach[0] + 2 * h.uv.magnitude() * reach[0] * reach[1] +
                 h.vv.magnitude() * reach[1] * reach[1]);
  const double least = std::max(height.lower, -height.upper);
  constexpr double slack = 1.000001;
  if (least > slack * most) return true;
  // Where h bends away from zero, its least value is no farther than the gradient and the curvature say.
  const double sign = height.lower > 0 ? 1 : -1;
  const double curvature_u = sign > 0 ? h.uu.lower : -h.uu.upper;
  const double curvature_v = sign > 0 ? h.vv.lower : -h.vv.upper;
  const double curvature = std::min(curvature_u, curvature_v) - h.uv.magnitude();
  const double slope = std::hypot(here->gradient[0].magnitude(), here->gradient[1].magnitude());
  return least > 0 && curvature > 0 && least * curvature > slack * 0.5 * slope * slope;
}

}  // namespace eliminant::bridge
