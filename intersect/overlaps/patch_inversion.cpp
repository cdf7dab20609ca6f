// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/overlaps/patch_inversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace eliminant::intersect {

using bridge::PatchJets;
using Eigen::Array4d;

namespace {

/// The best of a few parameters.
std::array<double, 2> nearest_start(PatchJets& patch, const Array4d& point) {
  std::array<double, 2> best{0.5, 0.5};
  double least = INFINITY;
  constexpr int parts = 16;
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; j <= parts; ++j) {
      const std::array<double, 2> at{static_cast<double>(i) / parts, static_cast<double>(j) / parts};
      const double d = (patch.at(at[0], at[1]).point - point).head<3>().matrix().squaredNorm();
      if (d < least) {
        least = d;
        best = at;
      }
    }
  return best;
}

}  // namespace

std::array<double, 2> parameters_near(PatchJets& patch, const Array4d& point, std::array<double, 2> at) {
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const PatchJets::Value value = patch.at(at[0], at[1]);
    const auto dot = [](const Array4d& a, const Array4d& b) { return (a * b).head<3>().sum(); };
    const Array4d difference = value.point - point;
    const double uu = dot(value.first[0], value.first[0]);
    const double uv = dot(value.first[0], value.first[1]);
    const double vv = dot(value.first[1], value.first[1]);
    const double p = dot(value.first[0], difference);
    const double q = dot(value.first[1], difference);
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 0)) break;
    const double du = (vv * p - uv * q) / determinant;
    const double dv = (uu * q - uv * p) / determinant;
    at = {std::clamp(at[0] - du, 0.0, 1.0), std::clamp(at[1] - dv, 0.0, 1.0)};
    if (std::fabs(du) + std::fabs(dv) < 1e-14) break;
  }
  return at;
}

std::array<double, 2> nearest_parameters(PatchJets& patch, const Array4d& point) {
  return parameters_near(patch, point, nearest_start(patch, point));
}

}  // namespace eliminant::intersect
