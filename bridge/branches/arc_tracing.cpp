// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/arc_tracing.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <eliminant/bridge/branches/arc_tube.hpp>
#include <eliminant/bridge/branches/patch_difference.hpp>

namespace eliminant::bridge {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

Vector4d vector_of(const std::array<double, 4>& values) { return {values[0], values[1], values[2], values[3]}; }

class ArcTracing {
 public:
  ArcTracing(PatchDifference& patches, const CellBox& box, double tolerance)
      : patches_(patches), tolerance_(tolerance) {
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
    const Vector4d goal = patches_.newton(to).x;
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
    Difference here = patches_.newton(from);
    add(arc, here);
    Vector4d tangent = tangent_at(here, turned_ ? here.x - goal : goal - here.x);
    Vector4d curvature = curvature_at(here, tangent);
    double step = std::min(0.25 * (goal - here.x).norm(), 1e-2);
    constexpr std::size_t most_points = 2000000;
    for (std::size_t steps = 0; arc.points.size() < most_points; ++steps) {
      if (steps % 64 == 0) context.checkpoint("tracing");
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
      const Difference next =
          patches_.newton(last ? goal : Vector4d(here.x + step * tangent + 0.5 * step * step * curvature));
      const Vector4d d = next.x - here.x;
      look_around(here, d);
      const ArcTube tube(patches_, bounds_, here, next);
      if (!add_step(arc, tube, next)) {
        step = std::min(step, d.norm()) * shorter(tube);
        if (!(step > 1e-13)) return arc;
        continue;
      }
      if (last) {
        arc.proven = true;
        return arc;
      }
      tangent = tangent_at(next, d);
      curvature = curvature_at(next, tangent);
      here = next;
      step *= std::clamp(longer(tube), 0.5, 2.0);
    }
    return arc;
  }

 private:
  static constexpr double filled_contraction = 0.3;
  /// As many points more than needed take about as long as another step.
  static constexpr double most_spare = 4;

  bool bound_derivatives(const Vector4d& lower, const Vector4d& upper) {
    const auto a = patches_.first().bounds_on(lower[0], upper[0], lower[1], upper[1]);
    const auto b = patches_.second().bounds_on(lower[2], upper[2], lower[3], upper[3]);
    if (!a || !b) return false;
    bounds_ = {*a, *b, lower, upper};
    return true;
  }

  /// Bounds for a step of d: those of the whole cell say little where derivatives differ much in it.
  void look_around(const Difference& here, const Vector4d& d) {
    const Vector4d unit = parameter_units(here);
    const double length = d.cwiseAbs().cwiseQuotient(unit).maxCoeff();
    constexpr double room = 2;
    constexpr double much = 16;
    const Vector4d near = room * (d.cwiseAbs() + length * unit);
    const Vector4d least_lower = (here.x - near).cwiseMax(cell_lower_);
    const Vector4d least_upper = (here.x + near).cwiseMin(cell_upper_);
    const bool enough =
        (least_lower.array() >= bounds_.lower.array()).all() && (least_upper.array() <= bounds_.upper.array()).all();
    const bool tight = ((bounds_.upper - bounds_.lower).array() <= much * (least_upper - least_lower).array()).all();
    if (enough && tight) return;
    const Vector4d far = 0.25 * much * near;
    bound_derivatives((here.x - far).cwiseMax(cell_lower_), (here.x + far).cwiseMin(cell_upper_));
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
    const Vector4d result = -(j.transpose() * (gram.inverse() * space_part(bend)));
    return result.allFinite() ? result : Vector4d(Vector4d::Zero());
  }

  /// The end of a step, and points between where one chord is too far from the arc.
  bool add_step(TracedArc& arc, const ArcTube& tube, const Difference& next) {
    double deviation = tube.deviation();
    spare_ = 0;
    if (!(deviation < tolerance_)) {
      if (!(tube.contraction() < filled_contraction)) return false;
      const std::optional<ArcTube::Filling> filling = tube.fill(patches_, tolerance_);
      if (!filling) return false;
      for (const Difference& point : filling->points) add(arc, point);
      deviation = filling->deviation;
      spare_ = filling->spare;
    }
    arc.error = std::max(arc.error, deviation);
    add(arc, next);
    return true;
  }

  /// By which factor to go on: the deviation is quadratic in the step, the contraction about linear; so is the change
  /// of the bend, and the number of points that it makes quadratic.
  double longer(const ArcTube& tube) const {
    const double by_contraction = 0.7 * filled_contraction / tube.contraction();
    const double by_points = spare_ > 0 ? std::sqrt(most_spare / spare_) : infinity;
    return std::max(0.9 * std::sqrt(tolerance_ / tube.deviation()), std::min(by_contraction, by_points));
  }

  double shorter(const ArcTube& tube) const {
    if (!tube.proven()) return 0.25;
    return std::clamp(0.8 * longer(tube), 0.05, 0.7);
  }

  void add(TracedArc& arc, const Difference& at) const {
    TracedPoint point;
    for (std::size_t k = 0; k < 4; ++k) point.parameters[k] = std::clamp(at.x[static_cast<long>(k)], 0.0, 1.0);
    for (std::size_t k = 0; k < 3; ++k) point.point[k] = at.first.point[static_cast<long>(k)];
    arc.points.push_back(point);
  }

  PatchDifference& patches_;
  double tolerance_;
  /// Whether to set out away from the goal.
  bool turned_ = false;
  /// Of the last step.
  double spare_ = 0;
  Vector4d cell_lower_;
  Vector4d cell_upper_;
  DifferenceBounds bounds_;
};

}  // namespace

ArcTracer::ArcTracer(const ControlNet& first, const ControlNet& second) : first_(first), second_(second) {}

TracedArc ArcTracer::trace(const CrossingPoint& from, const CrossingPoint& to, const CellBox& box, double tolerance,
                           const Context& context) {
  PatchDifference patches(first_, second_);
  ArcTracing tracing(patches, box, tolerance);
  return tracing.run(vector_of(from.parameters), vector_of(to.parameters), context);
}

TracedArc ArcTracer::trace_near(const std::array<double, 4>& from, const std::array<double, 4>& goal,
                                const CellBox& box, double near, double tolerance, const Context& context) {
  PatchDifference patches(first_, second_);
  ArcTracing tracing(patches, box, tolerance);
  return tracing.run(vector_of(from), vector_of(goal), near, context);
}

}  // namespace eliminant::bridge
