// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branch_tracing.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/QR>

#include <eliminant/bridge/patch_jets.hpp>

namespace eliminant::bridge {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

Vector4d vector_of(const std::array<double, 4>& values) { return {values[0], values[1], values[2], values[3]}; }

/// The difference of both patches at parameters x.
struct Difference {
  Vector4d x;
  Array4d value;
  double error = 0;
  /// Rows are coordinates, the last one is free; columns are u, v, s, t.
  Matrix4d jacobian = Matrix4d::Zero();
  PatchJets::Value first;
  PatchJets::Value second;
};

class ArcTracing {
 public:
  ArcTracing(PatchJets& first, PatchJets& second, const CellBox& box, double tolerance)
      : first_(first), second_(second), tolerance_(tolerance) {
    for (long k = 0; k < 4; ++k) {
      const auto i = static_cast<std::size_t>(k);
      constexpr double margin = 0.125;
      const double width = box.upper[i] - box.lower[i];
      cell_lower_[k] = box.lower[i] - margin * width;
      cell_upper_[k] = box.upper[i] + margin * width;
    }
  }

  /// To a regular point of the arc.
  TracedArc run(const Vector4d& from, const Vector4d& to, const Context& context) {
    const Vector4d goal = newton(to).x;
    TracedArc arc = run(from, goal, 0, context);
    if (arc.proven) return arc;
    // It may begin away from its end.
    turned_ = true;
    TracedArc other = run(from, goal, 0, context);
    return other.proven ? other : arc;
  }

  /// To a point, or only to within `near` of it when that is positive.
  TracedArc run(const Vector4d& from, const Vector4d& goal, double near, const Context& context) {
    TracedArc arc;
    if (!bound_derivatives(cell_lower_, cell_upper_)) return arc;
    Difference here = newton(from);
    add(arc, here);
    Vector4d tangent = tangent_at(here, turned_ ? here.x - goal : goal - here.x);
    Vector4d curvature = curvature_at(here, tangent);
    third_ = fourth_ = Vector4d::Zero();
    double step = std::min(0.25 * (goal - here.x).norm(), 1e-2);
    constexpr std::size_t most_points = 2000000;
    while (arc.points.size() < most_points) {
      if (arc.points.size() % 1024 == 0) context.checkpoint("tracing");
      const Vector4d rest = goal - here.x;
      const double left = rest.dot(tangent);
      if (near > 0) {
        if (rest.lpNorm<Eigen::Infinity>() < near) {
          arc.proven = true;
          return arc;
        }
        step = std::min(step, 0.3 * rest.norm());
      }
      const bool last = near == 0 && rest.norm() <= 1.5 * step && left > 0;
      const Difference next = last ? newton(goal) : newton(predicted(here.x, tangent, curvature, step));
      const Vector4d d = next.x - here.x;
      look_around(here, d);
      const double deviation = deviation_of(here, next, d);
      if (!(deviation < tolerance_)) {
        // The deviation is quadratic in the step.
        const double factor = std::isfinite(deviation) ? 0.8 * std::sqrt(tolerance_ / deviation) : 0.25;
        step = std::min(step, d.norm()) * std::clamp(factor, 0.05, 0.7);
        if (!(step > 1e-13)) return arc;
        continue;
      }
      arc.error = std::max(arc.error, deviation);
      add(arc, next);
      if (last) {
        arc.proven = true;
        return arc;
      }
      const Vector4d tangent_before = tangent;
      const Vector4d curvature_before = curvature;
      tangent = tangent_at(next, d);
      curvature = curvature_at(next, tangent);
      extrapolate(d, tangent_before, curvature_before, tangent, curvature);
      here = next;
      step *= std::clamp(0.9 * std::sqrt(tolerance_ / deviation), 0.5, 2.0);
    }
    return arc;
  }

 private:
  bool bound_derivatives(const Vector4d& lower, const Vector4d& upper) {
    const auto a = first_.bounds_on(lower[0], upper[0], lower[1], upper[1]);
    const auto b = second_.bounds_on(lower[2], upper[2], lower[3], upper[3]);
    if (!a || !b) return false;
    a_ = *a;
    b_ = *b;
    lower_ = lower;
    upper_ = upper;
    return true;
  }

  /// A step along the arc by its length.
  Vector4d predicted(const Vector4d& x, const Vector4d& tangent, const Vector4d& curvature, double step) const {
    return x + step * (tangent + step / 2 * (curvature + step / 3 * (third_ + step / 4 * fourth_)));
  }

  /// The third and fourth derivative of the parameters by the length of the arc, from first and second ones at both
  /// ends of the step d, to their lowest orders; they only make Newton's method shorter.
  void extrapolate(const Vector4d& d, const Vector4d& tangent_before, const Vector4d& curvature_before,
                   const Vector4d& tangent, const Vector4d& curvature) {
    const double chord = d.norm();
    const double length = chord * (1 + curvature.squaredNorm() * chord * chord / 24);
    // Without the terms of higher order p is x''' - x'''' length / 3, and q is x''' - x'''' length / 2.
    const Vector4d p = (tangent_before - tangent + length * curvature) * (2 / (length * length));
    const Vector4d q = (curvature - curvature_before) / length;
    third_ = 3 * p - 2 * q;
    fourth_ = (p - q) * (6 / length);
    if (!third_.allFinite() || !fourth_.allFinite()) third_ = fourth_ = Vector4d::Zero();
  }

  /// Bounds for a step of d: those of the whole cell say little where derivatives differ much in it.
  void look_around(const Difference& here, const Vector4d& d) {
    const Vector4d unit = units_of(here);
    const double length = d.cwiseAbs().cwiseQuotient(unit).maxCoeff();
    constexpr double room = 2;
    constexpr double much = 16;
    const Vector4d near = room * (d.cwiseAbs() + length * unit);
    const Vector4d least_lower = (here.x - near).cwiseMax(cell_lower_);
    const Vector4d least_upper = (here.x + near).cwiseMin(cell_upper_);
    const bool enough = (least_lower.array() >= lower_.array()).all() && (least_upper.array() <= upper_.array()).all();
    const bool tight = ((upper_ - lower_).array() <= much * (least_upper - least_lower).array()).all();
    if (enough && tight) return;
    // For the steps to come, which bend away from the direction of this one.
    constexpr double steps = 24;
    const Vector4d ahead = steps * d;
    const Vector4d beside = 2.5 * near;
    bound_derivatives((here.x - beside + ahead.cwiseMin(0)).cwiseMax(cell_lower_),
                      (here.x + beside + ahead.cwiseMax(0)).cwiseMin(cell_upper_));
  }

  /// By how much each parameter moves where the point in space moves by about one.
  static Vector4d units_of(const Difference& here) {
    Vector4d unit;
    for (long k = 0; k < 4; ++k) unit[k] = 1 / here.jacobian.col(k).head<3>().norm();
    // A parameter that moves nothing.
    const double least = unit.minCoeff();
    constexpr double at_most = 1e6;
    return unit.cwiseMin(at_most * least);
  }

  Difference difference_at(const Vector4d& x) {
    return difference_of(x, first_.at(x[0], x[1]), second_.at(x[2], x[3]));
  }

  static Difference difference_of(const Vector4d& x, const PatchJets::Value& first, const PatchJets::Value& second) {
    Difference result;
    result.first = first;
    result.second = second;
    const PatchJets::Value& a = result.first;
    const PatchJets::Value& b = result.second;
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

  /// To the nearest point of the curve.
  Difference newton(Vector4d x) {
    Difference here = difference_at(x);
    constexpr int most_steps = 8;
    for (int round = 0; round < most_steps; ++round) {
      const Eigen::Vector3d value(here.value[0], here.value[1], here.value[2]);
      if (!(value.lpNorm<Eigen::Infinity>() > 0.5 * here.error)) break;
      const Eigen::Matrix<double, 3, 4> j = here.jacobian.topRows<3>();
      const Eigen::Matrix3d gram = j * j.transpose();
      const Vector4d change = j.transpose() * (gram.inverse() * value);
      x -= change;
      if (move_little(here, x)) break;
      here = difference_at(x);
      if (!(change.lpNorm<Eigen::Infinity>() > 1e-9)) break;
    }
    return nearly_tangent(here) ? closest(here) : here;
  }

  /// Moves the difference by a little, to x, by Taylor's formula; false where that is less accurate than the steps
  /// need.
  bool move_little(Difference& at, const Vector4d& x) const {
    // The parameters are rounded.
    const Vector4d by = x - at.x;
    constexpr double little = 1e-9;
    if (!(by.lpNorm<Eigen::Infinity>() < little) || !is_bounded_at(x) || !is_bounded_at(at.x)) return false;
    const double error_a = error_of_move(a_, by[0], by[1]);
    const double error_b = error_of_move(b_, by[2], by[3]);
    constexpr double hardly_any = 1e-4;
    if (!(error_a + error_b < hardly_any * tolerance_)) return false;
    move(at.first, by[0], by[1], error_a);
    move(at.second, by[2], by[3], error_b);
    at = difference_of(x, at.first, at.second);
    return true;
  }

  bool is_bounded_at(const Vector4d& x) const {
    return (x.array() >= lower_.array()).all() && (x.array() <= upper_.array()).all();
  }

  /// The error of points that stands for those of their derivatives, too, when the second ones stay as they are: in
  /// derivatives of order k it counts times the k-th power of the steepness, which is at least 2. The second
  /// derivatives change by S at most, so that what Taylor's formula leaves of the first ones is below S (p + q) / 2,
  /// and of points below S (p + q)^2 / 6: far less.
  static double error_of_move(const DerivativeBounds& bounds, double p, double q) {
    p = std::fabs(p);
    q = std::fabs(q);
    const Array4d change = (bounds.third[0] * p + bounds.third[1] * q)
                               .max(bounds.third[1] * p + bounds.third[2] * q)
                               .max(bounds.third[2] * p + bounds.third[3] * q);
    return 0.25 * change.head<3>().maxCoeff();
  }

  static void move(PatchJets::Value& value, double p, double q, double error) {
    value.point += value.first[0] * p + value.first[1] * q + 0.5 * along(value.second, p, q);
    value.first[0] += value.second[0] * p + value.second[1] * q;
    value.first[1] += value.second[1] * p + value.second[2] * q;
    value.error += error + 4 * unit_roundoff * value.point.abs().head<3>().maxCoeff();
  }

  /// Whether the normal equations were too inaccurate for Newton's method.
  static bool nearly_tangent(const Difference& here) { return here.value.abs().head<3>().maxCoeff() > 4 * here.error; }

  /// By steps that do not square the condition, as long as they help.
  Difference closest(Difference here) {
    constexpr int most_steps = 4;
    for (int round = 0; round < most_steps && nearly_tangent(here); ++round) {
      const Eigen::Vector3d value(here.value[0], here.value[1], here.value[2]);
      const Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 3, 4>> least(here.jacobian.topRows<3>());
      const Difference next = difference_at(here.x - least.solve(value));
      if (!(next.value.abs().head<3>().maxCoeff() < value.lpNorm<Eigen::Infinity>())) break;
      here = next;
    }
    return here;
  }

  /// The unit vector in the kernel of the Jacobian matrix, on the side of `along`.
  static Vector4d tangent_at(const Difference& here, const Vector4d& along) {
    const Matrix4d& j = here.jacobian;
    Vector4d kernel;
    for (int k = 0; k < 4; ++k) {
      Eigen::Matrix3d minor;
      for (int c = 0, at = 0; c < 4; ++c)
        if (c != k) minor.col(at++) = j.col(c).head<3>();
      kernel[k] = (k % 2 == 0 ? 1 : -1) * minor.determinant();
    }
    kernel.normalize();
    return kernel.dot(along) < 0 ? Vector4d(-kernel) : kernel;
  }

  /// The second derivative of the parameters by the length of the arc among them, orthogonal to the tangent.
  static Vector4d curvature_at(const Difference& here, const Vector4d& tangent) {
    const Array4d bend =
        along(here.first.second, tangent[0], tangent[1]) - along(here.second.second, tangent[2], tangent[3]);
    const Eigen::Matrix<double, 3, 4> j = here.jacobian.topRows<3>();
    const Eigen::Matrix3d gram = j * j.transpose();
    const Vector4d result = -(j.transpose() * (gram.inverse() * vector_of(bend)));
    return result.allFinite() ? result : Vector4d(Vector4d::Zero());
  }

  /// A bound of the distance in space between the arc from `here` to `here` + d and its chord; infinity when it is not
  /// proven that there is exactly one arc near the chord.
  double deviation_of(const Difference& here, const Difference& next, const Vector4d& d) const {
    // All parameters in their units.
    const Vector4d unit = units_of(here);
    const Vector4d step = d.cwiseQuotient(unit);
    const double length = step.lpNorm<Eigen::Infinity>();
    if (!(length > 0) || !(length < infinity)) return infinity;
    Matrix4d system = here.jacobian * unit.asDiagonal();
    const double scale = system.topRows<3>().cwiseAbs().maxCoeff();
    system.row(3) = step.transpose() * (scale / step.norm());
    const Matrix4d inverse = system.inverse();
    if (!inverse.allFinite()) return infinity;
    const Matrix4d magnitude = inverse.cwiseAbs();
    // What derivatives by each parameter make of an error of the points.
    const Vector4d steepness = steepness_of();
    const double point_error = std::max({here.first.error, here.second.error, next.first.error, next.second.error});
    const double slope_error = point_error * steepness.cwiseProduct(unit).sum();
    // Of products with the inverse, relative to the whole.
    const double rounding = magnitude.rowwise().sum().maxCoeff() * (256 * unit_roundoff * scale + slope_error) + 1e-12;

    // The second derivatives along the chord, and by how much they change on it.
    const Array4d bend_a = along(here.first.second, d[0], d[1]);
    const Array4d bend_b = along(here.second.second, d[2], d[3]);
    const Array4d change_a = third_along(a_, d[0], d[1]);
    const Array4d change_b = third_along(b_, d[2], d[3]);
    const double bend_error = 2 * point_error * std::pow(steepness.dot(d.cwiseAbs()), 2);
    // Of the points that are taken for ends of the arc.
    const double ends = std::max(end_error(here), end_error(next)) + bend_error;
    Vector4d bend = Vector4d::Zero();
    Vector4d rest = Vector4d::Zero();
    for (long i = 0; i < 3; ++i) {
      bend[i] = bend_a[i] - bend_b[i];
      rest[i] = 0.125 * (change_a[i] + change_b[i]) + ends;
    }
    const Vector4d offset = inverse * bend;
    const double offset_error = (magnitude * rest).lpNorm<Eigen::Infinity>();
    const double largest_offset = 0.125 * offset.lpNorm<Eigen::Infinity>() * (1 + rounding) + offset_error;
    const double radius = 2.5 * largest_offset;
    for (long k = 0; k < 4; ++k)
      if (std::min(here.x[k], here.x[k] + d[k]) - radius * unit[k] < lower_[k] ||
          std::max(here.x[k], here.x[k] + d[k]) + radius * unit[k] > upper_[k])
        return infinity;
    const Vector4d reach = step.cwiseAbs() + Vector4d::Constant(radius);
    const JacobianChange change = change_of_jacobian(here, unit, reach, inverse, point_error * steepness);
    const double contraction = change.solved.rowwise().sum().maxCoeff() + rounding;
    constexpr double at_most = 0.55;
    if (!(contraction < at_most)) return infinity;
    const double distance = largest_offset / (1 - contraction);

    // In space: the bend of the arc, of which only the part across the chord counts, and what is left.
    const std::array<Eigen::Vector3d, 2> slope{vector_of(here.first.first[0]) * unit[0],
                                               vector_of(here.first.first[1]) * unit[1]};
    const Eigen::Vector3d chord = slope[0] * step[0] + slope[1] * step[1];
    Eigen::Vector3d sag = slope[0] * offset[0] + slope[1] * offset[1] - vector_of(bend_a);
    const double chord_square = chord.squaredNorm();
    if (chord_square > 0) {
      // The foot on the chord must not move beyond its ends.
      const double shift = sag.dot(chord) / chord_square;
      if (std::fabs(shift) < 1) sag -= chord * shift;
    }
    double remainder = 0;
    for (long i = 0; i < 3; ++i) {
      const double slopes = std::fabs(slope[0][i]) + std::fabs(slope[1][i]);
      remainder =
          std::max(remainder, slopes * (offset_error + contraction * distance) +
                                  (change.plain(i, 0) + change.plain(i, 1)) * distance + 0.125 * change_a[i] + ends);
    }
    return 0.125 * (sag.norm() + rounding * bend.norm()) + 1.74 * remainder;
  }

  /// Bounds how much the Jacobian matrix, in units of the parameters, changes from `here` to points within `reach`.
  struct JacobianChange {
    Eigen::Matrix<double, 3, 4> plain;
    /// Of its product with the inverse: where the patches are nearly tangent a column changes mostly along itself,
    /// which the product of absolute values does not tell.
    Matrix4d solved;
  };

  /// By the second derivatives at `here` and bounds of the third; `error` bounds those of points, times steepness.
  JacobianChange change_of_jacobian(const Difference& here, const Vector4d& unit, const Vector4d& reach,
                                    const Matrix4d& inverse, const Vector4d& error) const {
    const Eigen::Matrix<double, 4, 3> solve = inverse.leftCols<3>();
    const Vector4d moved = reach.cwiseProduct(unit);
    const Vector4d steepness = steepness_of();
    JacobianChange change;
    for (long own = 0; own < 4; own += 2) {
      const auto& second = own == 0 ? here.first.second : here.second.second;
      const auto& third = own == 0 ? a_.third : b_.third;
      const double p = moved[own];
      const double q = moved[own + 1];
      for (long k = 0; k < 2; ++k) {
        const auto order = static_cast<std::size_t>(k);
        const double own_unit = unit[own + k];
        const Eigen::Vector3d by_p = vector_of(second[order]) * (p * own_unit);
        const Eigen::Vector3d by_q = vector_of(second[order + 1]) * (q * own_unit);
        const Array4d rest =
            (third[order] * (p * p) + third[order + 1] * (2 * p * q) + third[order + 2] * (q * q)) * (0.5 * own_unit);
        const double rounded = 2 * own_unit * error[own + k] * (steepness[own] * p + steepness[own + 1] * q);
        const Eigen::Vector3d bound = vector_of(rest) + Eigen::Vector3d::Constant(rounded);
        change.plain.col(own + k) = by_p.cwiseAbs() + by_q.cwiseAbs() + bound;
        change.solved.col(own + k) = (solve * by_p).cwiseAbs() + (solve * by_q).cwiseAbs() + solve.cwiseAbs() * bound;
      }
    }
    return change;
  }

  /// By how much derivatives by each parameter multiply errors of points.
  Vector4d steepness_of() const {
    Vector4d result;
    for (std::size_t k = 0; k < 4; ++k) {
      const PatchJets& patch = k < 2 ? first_ : second_;
      const DerivativeBounds& bounds = k < 2 ? a_ : b_;
      // The change of the weight, relative to it.
      const double of_weight = bounds.first[k % 2][3];
      result[static_cast<long>(k)] = 2 * static_cast<double>(patch.degree(k % 2)) + of_weight;
    }
    return result;
  }

  static Eigen::Vector3d vector_of(const Array4d& a) { return {a[0], a[1], a[2]}; }

  /// Between the values of both patches at a point that is taken for one of the curve.
  static double end_error(const Difference& at) { return at.value.abs().head<3>().maxCoeff() + at.error; }

  /// The change of the second derivative in the direction (p, q) from one end to the other, bounded.
  static Array4d third_along(const DerivativeBounds& bounds, double p, double q) {
    p = std::fabs(p);
    q = std::fabs(q);
    return bounds.third[0] * (p * p * p) + bounds.third[1] * (3 * p * p * q) + bounds.third[2] * (3 * p * q * q) +
           bounds.third[3] * (q * q * q);
  }

  void add(TracedArc& arc, const Difference& at) const {
    TracedPoint point;
    for (std::size_t k = 0; k < 4; ++k) point.parameters[k] = std::clamp(at.x[static_cast<long>(k)], 0.0, 1.0);
    for (std::size_t k = 0; k < 3; ++k) point.point[k] = at.first.point[static_cast<long>(k)];
    arc.points.push_back(point);
  }

  PatchJets& first_;
  PatchJets& second_;
  double tolerance_;
  /// Whether to set out away from the goal.
  bool turned_ = false;
  Vector4d cell_lower_;
  Vector4d cell_upper_;
  /// Derivatives of the arc at the last point, as far as they are known.
  Vector4d third_ = Vector4d::Zero();
  Vector4d fourth_ = Vector4d::Zero();
  /// Where the bounds hold.
  Vector4d lower_;
  Vector4d upper_;
  DerivativeBounds a_;
  DerivativeBounds b_;
};

}  // namespace

BranchTracer::BranchTracer(const ControlNet& first, const ControlNet& second) : first_(first), second_(second) {}

TracedArc BranchTracer::trace(const CrossingPoint& from, const CrossingPoint& to, const CellBox& box, double tolerance,
                              const Context& context) {
  PatchJets first(first_);
  PatchJets second(second_);
  ArcTracing tracing(first, second, box, tolerance);
  return tracing.run(vector_of(from.parameters), vector_of(to.parameters), context);
}

TracedArc BranchTracer::trace_near(const std::array<double, 4>& from, const std::array<double, 4>& goal,
                                   const CellBox& box, double near, double tolerance, const Context& context) {
  PatchJets first(first_);
  PatchJets second(second_);
  ArcTracing tracing(first, second, box, tolerance);
  return tracing.run(vector_of(from), vector_of(goal), near, context);
}

}  // namespace eliminant::bridge
