// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/branch_tube.hpp>

#include <cmath>

#include <Eigen/Dense>

namespace eliminant::intersect {

namespace {

using Matrix34 = Eigen::Matrix<double, 3, 4>;

std::array<std::size_t, 3> others(std::size_t axis) {
  std::array<std::size_t, 3> result{};
  for (std::size_t i = 0, k = 0; i < 4; ++i)
    if (i != axis) result[k++] = i;
  return result;
}

ParameterBox box_of(const BranchPoint& point) { return {point.at[0], point.at[1], point.at[2], point.at[3]}; }

template <class Number>
SurfacePair::EquationsIn<Number> equations_of(const JetOf<Number>& phi, const JetOf<Number>& psi, std::size_t k) {
  SurfacePair::EquationsIn<Number> result;
  for (std::size_t i = 0, row = 0; i < 4; ++i) {
    if (i == k) continue;
    result.value[row] = phi.value[i] * psi.value[k] - phi.value[k] * psi.value[i];
    for (std::size_t j = 0; j < 2; ++j) {
      result.jacobian[row][j] = phi.derivative[j][i] * psi.value[k] - phi.derivative[j][k] * psi.value[i];
      result.jacobian[row][2 + j] = phi.value[i] * psi.derivative[j][k] - phi.value[k] * psi.derivative[j][i];
    }
    ++row;
  }
  return result;
}

Matrix34 matrix_of(const SurfacePair::EquationsIn<double>& equations) {
  Matrix34 result;
  for (long i = 0; i < 3; ++i)
    for (long j = 0; j < 4; ++j)
      result(i, j) = equations.jacobian[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return result;
}

Matrix34 midpoint_jacobian(const SurfacePair::Equations& equations) {
  Matrix34 result;
  for (long i = 0; i < 3; ++i)
    for (long j = 0; j < 4; ++j)
      result(i, j) = middle(equations.jacobian[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  return result;
}

Eigen::Matrix3d without_column(const Matrix34& jacobian, std::size_t axis) {
  Eigen::Matrix3d result;
  const auto unknowns = others(axis);
  for (long k = 0; k < 3; ++k) result.col(k) = jacobian.col(static_cast<long>(unknowns[static_cast<std::size_t>(k)]));
  return result;
}

}  // namespace

ParameterBox in_charts(const ParameterBox& box, const Charts& from, const Charts& to) {
  ParameterBox result = box;
  for (std::size_t i = 0; i < 4; ++i)
    if (from[i] != to[i]) result[i] = inverse(box[i]);
  return result;
}

SurfacePair::Equations SurfacePair::equations(const Charts& inverted, const ParameterBox& box, std::size_t k) const {
  const SurfaceJet phi = first_.jet({inverted[0], inverted[1]}, {box[0], box[1]});
  const SurfaceJet psi = second_.jet({inverted[2], inverted[3]}, {box[2], box[3]});
  Equations result = equations_of(phi, psi, k);
  result.valid = phi.value[k].excludes_zero() && psi.value[k].excludes_zero();
  return result;
}

SurfacePair::EquationsIn<double> SurfacePair::approximate_equations(const BranchPoint& point, std::size_t k) const {
  return equations_of(first_.approximate_jet({point.inverted[0], point.inverted[1]}, {point.at[0], point.at[1]}),
                      second_.approximate_jet({point.inverted[2], point.inverted[3]}, {point.at[2], point.at[3]}), k);
}

std::size_t SurfacePair::pivot(const BranchPoint& point) const {
  const auto phi = first_.approximate_jet({point.inverted[0], point.inverted[1]}, {point.at[0], point.at[1]}).value;
  const auto psi = second_.approximate_jet({point.inverted[2], point.inverted[3]}, {point.at[2], point.at[3]}).value;
  std::size_t best = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (std::fabs(phi[k] * psi[k]) > std::fabs(phi[best] * psi[best])) best = k;
  return best;
}

bool SurfacePair::excludes(const Charts& inverted, const ParameterBox& box) const {
  const auto phi = first_.value({inverted[0], inverted[1]}, {box[0], box[1]});
  const auto psi = second_.value({inverted[2], inverted[3]}, {box[2], box[3]});
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if ((phi[i] * psi[k] - phi[k] * psi[i]).excludes_zero()) return true;
  return false;
}

SpaceBox SurfacePair::point(const Charts& inverted, const ParameterBox& box) const {
  const auto phi = first_.value({inverted[0], inverted[1]}, {box[0], box[1]});
  return {phi[0] / phi[3], phi[1] / phi[3], phi[2] / phi[3]};
}

SpaceBox SurfacePair::second_point(const Charts& inverted, const ParameterBox& box) const {
  const auto psi = second_.value({inverted[2], inverted[3]}, {box[2], box[3]});
  return {psi[0] / psi[3], psi[1] / psi[3], psi[2] / psi[3]};
}

SpaceBox SurfacePair::velocity(const Charts& inverted, const ParameterBox& box, const ParameterBox& parameters) const {
  const SurfaceJet phi = first_.jet({inverted[0], inverted[1]}, {box[0], box[1]});
  const DoubleInterval scale = inverse(phi.value[3] * phi.value[3]);
  SpaceBox result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      result[i] = result[i] +
                  (phi.derivative[j][i] * phi.value[3] - phi.value[i] * phi.derivative[j][3]) * scale * parameters[j];
  return result;
}

bool BranchTube::holds(const ParameterBox& box) const {
  const DoubleInterval along = box[axis] - DoubleInterval(centre.at[axis]);
  if (!contains(range, along)) return false;
  for (const std::size_t i : others(axis)) {
    const DoubleInterval off = box[i] - DoubleInterval(centre.at[i]) - DoubleInterval(slope[i]) * along;
    if (!(off.magnitude() <= radius[i])) return false;
  }
  return true;
}

std::optional<BranchTube> enclose_branch(const SurfacePair& pair, const BranchPoint& centre, std::size_t axis,
                                         const std::array<double, 4>& slope, const DoubleInterval& range,
                                         double floor) {
  const std::size_t k = pair.pivot(centre);
  const auto unknowns = others(axis);
  const auto at_centre = pair.equations(centre.inverted, box_of(centre), k);
  const Eigen::Matrix3d inverse_jacobian = without_column(midpoint_jacobian(at_centre), axis).inverse();
  if (!inverse_jacobian.allFinite()) return std::nullopt;
  const auto precondition = [&](const std::array<DoubleInterval, 3>& v) {
    std::array<DoubleInterval, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        result[i] = result[i] + DoubleInterval(inverse_jacobian(static_cast<long>(i), static_cast<long>(j))) * v[j];
    return result;
  };
  BranchTube tube;
  tube.centre = centre;
  tube.axis = axis;
  tube.slope = slope;
  tube.slope[axis] = 1;
  tube.range = range;

  const auto hull_of = [&](const std::array<double, 4>& radius) {
    ParameterBox hull;
    for (std::size_t i = 0; i < 4; ++i)
      hull[i] =
          DoubleInterval(centre.at[i]) + DoubleInterval(tube.slope[i]) * range + DoubleInterval(-radius[i], radius[i]);
    return hull;
  };
  // Values on the line: F(centre) + difference * (derivative along the line).
  const auto residual = precondition(at_centre.value);
  const auto drift_on = [&](const SurfacePair::Equations& equations) {
    std::array<DoubleInterval, 3> along;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        along[i] = along[i] + equations.jacobian[i][j] * DoubleInterval(tube.slope[j]);
    return precondition(along);
  };
  const bool is_point = range.lower == 0 && range.upper == 0;
  const auto on_line = is_point ? at_centre : pair.equations(centre.inverted, hull_of({}), k);
  const auto line_drift = drift_on(on_line);
  std::array<double, 3> offset{};
  double largest = floor;
  for (std::size_t i = 0; i < 3; ++i) {
    offset[i] = (residual[i] + line_drift[i] * range).magnitude();
    largest = std::max(largest, 2 * offset[i]);
  }
  if (!std::isfinite(largest)) return std::nullopt;
  for (const std::size_t i : unknowns) tube.radius[i] = largest;
  tube.hull = hull_of(tube.radius);
  const auto on_tube = pair.equations(centre.inverted, tube.hull, k);
  if (!on_tube.valid) return std::nullopt;
  const auto drift = drift_on(on_tube);
  double contraction = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double row = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      DoubleInterval entry(i == j ? -1.0 : 0.0);
      for (std::size_t l = 0; l < 3; ++l)
        entry = entry + DoubleInterval(inverse_jacobian(static_cast<long>(i), static_cast<long>(l))) *
                            on_tube.jacobian[l][unknowns[j]];
      row += entry.magnitude();
    }
    row *= 1 + 0x1p-50;
    contraction = std::max(contraction, row);
    if (!(offset[i] + row * largest * (1 + 0x1p-50) < largest)) return std::nullopt;
  }
  if (!(contraction < 0.75)) return std::nullopt;
  // The velocity differs from the slope by -J^-1 (derivative along the line).
  for (std::size_t i = 0; i < 4; ++i) tube.velocity[i] = tube.slope[i];
  double deviation = 0;
  for (std::size_t i = 0; i < 3; ++i) deviation = std::max(deviation, drift[i].magnitude());
  deviation = deviation / (1 - contraction) * (1 + 0x1p-48);
  for (std::size_t i = 0; i < 3; ++i)
    tube.velocity[unknowns[i]] = DoubleInterval(tube.slope[unknowns[i]]) + DoubleInterval(-deviation, deviation);
  return tube;
}

bool approximate_branch_point(const SurfacePair& pair, BranchPoint& point, std::size_t axis) {
  const auto unknowns = others(axis);
  for (int step = 0; step < 12; ++step) {
    const auto equations = pair.approximate_equations(point, pair.pivot(point));
    const Eigen::Vector3d value(equations.value[0], equations.value[1], equations.value[2]);
    const Eigen::Vector3d change = without_column(matrix_of(equations), axis).inverse() * value;
    double scale = 1;
    for (const double x : point.at) scale = std::max(scale, std::fabs(x));
    if (!change.allFinite() || change.norm() > 4 * scale) return false;
    for (long i = 0; i < 3; ++i) point.at[unknowns[static_cast<std::size_t>(i)]] -= change[i];
    if (change.norm() < 2e-15 * scale) return true;
    if (step > 6 && change.norm() < 1e-12 * scale) return true;
  }
  return false;
}

std::optional<std::array<double, 4>> branch_direction(const SurfacePair& pair, const BranchPoint& point) {
  const Matrix34 jacobian = matrix_of(pair.approximate_equations(point, pair.pivot(point)));
  if (!jacobian.allFinite()) return std::nullopt;
  // The kernel of a 3 x 4 matrix: its maximal minors with alternating signs.
  std::array<double, 4> direction{};
  double square = 0;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    direction[axis] = (axis % 2 == 0 ? 1 : -1) * without_column(jacobian, axis).determinant();
    square += direction[axis] * direction[axis];
  }
  if (!(square > 0)) return std::nullopt;
  for (double& d : direction) d /= std::sqrt(square);
  return direction;
}

std::optional<PointEnclosure> enclose_branch_point(const SurfacePair& pair, const BranchPoint& point,
                                                   std::size_t axis) {
  BranchPoint refined = point;
  if (!approximate_branch_point(pair, refined, axis)) return std::nullopt;
  double scale = 1;
  for (const double x : refined.at) scale = std::max(scale, std::fabs(x));
  for (const double floor : {1e-15, 1e-13, 1e-11})
    if (const auto tube = enclose_branch(pair, refined, axis, {}, DoubleInterval(0), floor * scale))
      return PointEnclosure{refined.inverted, tube->hull};
  return std::nullopt;
}

}  // namespace eliminant::intersect
