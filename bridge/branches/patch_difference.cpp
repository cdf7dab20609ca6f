// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/patch_difference.hpp>

#include <Eigen/LU>
#include <Eigen/QR>

namespace eliminant::bridge {

namespace {

using Eigen::Vector4d;

Difference difference_of(const Vector4d& x, const PatchJets::Value& a, const PatchJets::Value& b) {
  Difference result;
  result.first = a;
  result.second = b;
  result.x = x;
  result.value = a.point - b.point;
  result.error = a.error + b.error + 4 * unit_roundoff * a.point.abs().head<3>().maxCoeff();
  for (long i = 0; i < 3; ++i) {
    result.jacobian(i, 0) = a.first[0][i];
    result.jacobian(i, 1) = a.first[1][i];
    result.jacobian(i, 2) = -b.first[0][i];
    result.jacobian(i, 3) = -b.first[1][i];
  }
  return result;
}

/// Whether the normal equations were too inaccurate for Newton's method.
bool nearly_tangent(const Difference& here) { return here.value.abs().head<3>().maxCoeff() > 4 * here.error; }

}  // namespace

Vector4d parameter_units(const Difference& here) {
  Vector4d unit;
  for (long k = 0; k < 4; ++k) unit[k] = 1 / here.jacobian.col(k).head<3>().norm();
  // A parameter that moves nothing.
  const double least = unit.minCoeff();
  constexpr double at_most = 1e6;
  return unit.cwiseMin(at_most * least);
}

Difference PatchDifference::at(const Vector4d& x) {
  return difference_of(x, first_.at(x[0], x[1]), second_.at(x[2], x[3]));
}

Difference PatchDifference::slopes_at(const Vector4d& x) {
  return difference_of(x, first_.slopes_at(x[0], x[1]), second_.slopes_at(x[2], x[3]));
}

Difference PatchDifference::newton(Vector4d x) {
  Difference here = at(x);
  constexpr int most_steps = 8;
  for (int round = 0; round < most_steps; ++round) {
    const Eigen::Vector3d value = space_part(here.value);
    if (!(value.lpNorm<Eigen::Infinity>() > 0.5 * here.error)) break;
    const Eigen::Matrix<double, 3, 4> j = here.jacobian.topRows<3>();
    const Eigen::Matrix3d gram = j * j.transpose();
    const Vector4d change = j.transpose() * (gram.inverse() * value);
    x -= change;
    here = at(x);
    if (!(change.lpNorm<Eigen::Infinity>() > 1e-9)) break;
  }
  return nearly_tangent(here) ? closest(here) : here;
}

/// By steps that do not square the condition, as long as they help.
Difference PatchDifference::closest(Difference here) {
  constexpr int most_steps = 4;
  for (int round = 0; round < most_steps && nearly_tangent(here); ++round) {
    const Eigen::Vector3d value = space_part(here.value);
    const Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 3, 4>> least(here.jacobian.topRows<3>());
    const Difference next = at(here.x - least.solve(value));
    if (!(next.value.abs().head<3>().maxCoeff() < value.lpNorm<Eigen::Infinity>())) break;
    here = next;
  }
  return here;
}

}  // namespace eliminant::bridge
