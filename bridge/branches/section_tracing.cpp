// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/section_tracing.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include <eliminant/bridge/nets/function_net.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>

namespace eliminant::bridge {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Parameters may leave [0, 1] by that.
constexpr double margin = 0x1p-7;
/// Tubes are at least that wide in the parameters, which is far above the errors of the points that are joined.
constexpr double least_radius = 1e-12;
/// Distance in the parameters from the place where the weight vanishes within which an arc to infinity may be left.
constexpr double near_infinity = 0.05;

Vector3d in_space(const Array4d& a) { return {a[0], a[1], a[2]}; }

/// The change of the second derivative along d, bounded.
Array4d third_along(const DerivativeBounds& bounds, const Vector2d& d) {
  const double p = std::fabs(d[0]);
  const double q = std::fabs(d[1]);
  return bounds.third[0] * (p * p * p) + bounds.third[1] * (3 * p * p * q) + bounds.third[2] * (3 * p * q * q) +
         bounds.third[3] * (q * q * q);
}

Matrix2d symmetric(const std::array<Array4d, 3>& second, long coordinate) {
  Matrix2d h;
  h << second[0][coordinate], second[1][coordinate], second[1][coordinate], second[2][coordinate];
  return h;
}

/// The jets of f and the patch.
struct Place {
  Vector2d x = Vector2d::Zero();
  PatchJets::Value f;
  PatchJets::Value patch;

  Vector2d gradient() const { return {f.first[0][0], f.first[1][0]}; }
  Matrix2d hessian() const { return symmetric(f.second, 0); }
  /// Bounds f at the true place next to this one.
  double end_error() const { return std::fabs(f.point[0]) + f.error; }
  double distance_from_origin() const { return in_space(patch.point).lpNorm<Eigen::Infinity>(); }
};

/// Derivative bounds on a box of parameters.
struct Cell {
  Vector2d lower = Vector2d::Zero();
  Vector2d upper = Vector2d::Zero();
  DerivativeBounds f;
  DerivativeBounds patch;

  bool contains(const Vector2d& low, const Vector2d& high) const {
    return (low.array() >= lower.array()).all() && (high.array() <= upper.array()).all();
  }
};

/// The zero directions of an indefinite form.
std::optional<Matrix2d> zero_directions(const Matrix2d& h) {
  const double discriminant = h(0, 1) * h(0, 1) - h(0, 0) * h(1, 1);
  if (!(discriminant > 0)) return std::nullopt;
  // One root of h00 a^2 + 2 h01 a b + h11 b^2 without cancellation, the other one from the product of both.
  const double sum = h(0, 1) + std::copysign(std::sqrt(discriminant), h(0, 1));
  Matrix2d directions;
  directions.col(0) = Vector2d(-sum, h(0, 0)).normalized();
  directions.col(1) = Vector2d(h(1, 1), -sum).normalized();
  return directions;
}

class Tracing {
 public:
  Tracing(const ControlNet& patch, const ControlNet& function, const SectionGoal& goal, double tolerance, double reach)
      : patch_(patch), f_(function), function_(function), goal_(goal), tolerance_(tolerance), reach_(reach) {}

  SectionArc run(const Vector2d& seed, double seed_radius, const Vector2d& side, const Context& context) {
    here_ = newton(seed);
    add(here_);
    if (!((here_.x - seed).lpNorm<Eigen::Infinity>() <= seed_radius)) return arc_;
    const Vector2d end(goal_.at[0], goal_.at[1]);
    Vector2d tangent = tangent_at(here_, side);
    double step = std::min(0.25 * (end - here_.x).norm(), 1e-2);
    constexpr std::size_t most_points = 2000000;
    constexpr double least_step = 1e-10;
    while (arc_.points.size() < most_points) {
      if (arc_.points.size() % 1024 == 0) context.checkpoint("tracing");
      const Vector2d rest = end - here_.x;
      const double allowed = tolerance_ * std::max(1.0, here_.distance_from_origin() / reach_);
      if (goal_.kind == SectionEnd::infinity) {
        if (here_.distance_from_origin() > 100 * reach_ && rest.norm() < near_infinity) return finish(0);
        step = std::min(step, 0.3 * rest.norm());
      } else if (goal_.kind != SectionEnd::regular) {
        const auto error = chord_error(rest);
        if (error && *error < allowed) return finish_at_goal(*error);
        step = std::min(step, 0.3 * rest.norm());
      }
      const bool last = goal_.kind == SectionEnd::regular && rest.norm() <= 1.5 * step && rest.dot(tangent) > 0;
      const Place next = last ? newton(end) : newton(here_.x + step * tangent + 0.5 * step * step * bend_at(tangent));
      const Vector2d d = next.x - here_.x;
      const bool missed = last && !((next.x - end).lpNorm<Eigen::Infinity>() < 0.5 * least_radius);
      const double deviation = missed ? infinity : deviation_of(next, d);
      if (!(deviation < allowed)) {
        // The deviation is quadratic in the step.
        const double factor = std::isfinite(deviation) ? 0.8 * std::sqrt(allowed / deviation) : 0.25;
        step = std::min(step, d.norm()) * std::clamp(factor, 0.05, 0.7);
        if (!(step > least_step)) return give_up(rest);
        continue;
      }
      arc_.error = std::max(arc_.error, deviation);
      here_ = next;
      add(here_);
      if (last) return finish(0);
      tangent = tangent_at(here_, d);
      step *= std::clamp(0.9 * std::sqrt(allowed / deviation), 0.5, 2.0);
    }
    return arc_;
  }

 private:
  SectionArc finish(double error) {
    arc_.error = std::max(arc_.error, error);
    arc_.proven = true;
    return arc_;
  }

  SectionArc finish_at_goal(double error) {
    add(place_at({goal_.at[0], goal_.at[1]}));
    return finish(error);
  }

  /// Where no step is proven any more: to the goal by whatever bound there is.
  SectionArc give_up(const Vector2d& rest) {
    // An arc to infinity may be left earlier.
    if (goal_.kind == SectionEnd::infinity && here_.distance_from_origin() > 1.5 * reach_ &&
        rest.norm() < 3 * near_infinity)
      return finish(0);
    if (goal_.kind != SectionEnd::node && goal_.kind != SectionEnd::singular) return arc_;
    if (const auto error = chord_error(rest)) return finish_at_goal(*error);
    add(place_at({goal_.at[0], goal_.at[1]}));
    return arc_;
  }

  Place place_at(const Vector2d& x) {
    Place place;
    place.x = x;
    place.f = f_.at(x[0], x[1]);
    place.patch = patch_.at(x[0], x[1]);
    return place;
  }

  /// To the nearest zero of f.
  Place newton(Vector2d x) {
    PatchJets::Value f = f_.at(x[0], x[1]);
    constexpr int most_steps = 8;
    for (int round = 0; round < most_steps; ++round) {
      if (!(std::fabs(f.point[0]) > 0.5 * f.error)) break;
      const Vector2d gradient(f.first[0][0], f.first[1][0]);
      const Vector2d change = gradient * (f.point[0] / gradient.squaredNorm());
      if (!change.allFinite() || change.norm() > 0.1) break;
      x -= change;
      f = f_.at(x[0], x[1]);
      if (!(change.lpNorm<Eigen::Infinity>() > 1e-9)) break;
    }
    return place_at(x);
  }

  static Vector2d tangent_at(const Place& place, const Vector2d& side) {
    const Vector2d gradient = place.gradient();
    const Vector2d tangent = Vector2d(-gradient[1], gradient[0]).normalized();
    return tangent.dot(side) < 0 ? Vector2d(-tangent) : tangent;
  }

  /// The second derivative of the parameters by the length of the arc among them.
  Vector2d bend_at(const Vector2d& tangent) const {
    const Vector2d gradient = here_.gradient();
    const Vector2d bend = gradient * (-tangent.dot(here_.hessian() * tangent) / gradient.squaredNorm());
    return bend.allFinite() ? bend : Vector2d(Vector2d::Zero());
  }

  static std::optional<DerivativeBounds> bounds_within(const PatchJets& jets, const Vector2d& low,
                                                       const Vector2d& high) {
    const Vector2d lower = low.array().max(-margin);
    const Vector2d upper = high.array().min(1 + margin);
    return jets.bounds_on(lower[0], upper[0], lower[1], upper[1]);
  }

  /// Derivative bounds on a box that holds this one, and not much more.
  bool cover(const Vector2d& low, const Vector2d& high) {
    if ((low.array() < -margin).any() || (high.array() > 1 + margin).any()) return false;
    const double width = (high - low).maxCoeff();
    if (cell_ && cell_->contains(low, high) && (cell_->upper - cell_->lower).maxCoeff() < 64 * width) return true;
    // On very small boxes the differences of control points are all rounding, and f may have a small gradient; near a
    // zero of the weight derivatives of the patch grow fast.
    constexpr double least_width = 0x1p-9;
    const double wide = std::max(6 * width, least_width);
    const auto f = bounds_within(f_, low.array() - wide, high.array() + wide);
    for (const double more : {6 * width, 0.0}) {
      Cell cell;
      cell.lower = (low.array() - more).max(-margin);
      cell.upper = (high.array() + more).min(1 + margin);
      const auto patch = bounds_within(patch_, cell.lower, cell.upper);
      if (!f || !patch) continue;
      cell.f = *f;
      cell.patch = *patch;
      cell_ = cell;
      return true;
    }
    return false;
  }

  /// A bound of the distance in space between the arc from here to here + d and its chord; infinity when it is not
  /// proven that there is exactly one arc near the chord.
  double deviation_of(const Place& next, const Vector2d& d) {
    const double length = d.lpNorm<Eigen::Infinity>();
    if (!(length > 0)) return infinity;
    const double wide = 0.25 * length;
    if (!cover(here_.x.cwiseMin(next.x).array() - wide, here_.x.cwiseMax(next.x).array() + wide)) return infinity;
    const Vector2d gradient = here_.gradient();
    const double scale = gradient.lpNorm<Eigen::Infinity>();
    Matrix2d system;
    system << gradient.transpose(), d.transpose() * (scale / d.norm());
    const Matrix2d inverse = system.inverse();
    if (!inverse.allFinite()) return infinity;
    const Matrix2d magnitude = inverse.cwiseAbs();
    // Of products with the inverse, relative to the whole.
    const double rounding = 64 * unit_roundoff * magnitude.rowwise().sum().maxCoeff() * 4 * scale + 1e-12;

    // f on the chord, by its second derivative here and the change of that.
    const double ends = std::max(here_.end_error(), next.end_error());
    const double bend = d.dot(here_.hessian() * d);
    const double bend_change = 0.125 * third_along(cell_->f, d)[0] + ends;
    const Vector2d offset = inverse.col(0) * bend;
    const double offset_error = magnitude.col(0).maxCoeff() * bend_change;
    const double largest_offset = 0.125 * offset.lpNorm<Eigen::Infinity>() * (1 + rounding) + offset_error;
    const double radius = std::max(2.5 * largest_offset, least_radius);
    if (!(radius < wide)) return infinity;
    // How much the gradient changes up to where the solutions are.
    const double reach = length + radius;
    const auto& second = cell_->f.second;
    const Vector2d change(second[0][0] + second[1][0], second[1][0] + second[2][0]);
    const double contraction = magnitude.col(0).maxCoeff() * change.sum() * reach + rounding;
    constexpr double at_most = 0.55;
    if (!(contraction < at_most)) return infinity;
    return deviation_in_space(d, offset, largest_offset / (1 - contraction),
                              offset_error + contraction * largest_offset / (1 - contraction), reach, rounding, next);
  }

  /// Of an arc that is, in the parameters, within `rest` of `offset` t (1 - t) / 2 off its chord, and within
  /// `distance`.
  double deviation_in_space(const Vector2d& d, const Vector2d& offset, double distance, double rest, double reach,
                            double rounding, const Place& next) const {
    const PatchJets::Value& at = here_.patch;
    const Array4d bend = along(at.second, d[0], d[1]);
    const Array4d bend_change = third_along(cell_->patch, d);
    const Vector3d chord = in_space(at.first[0]) * d[0] + in_space(at.first[1]) * d[1];
    Vector3d sag = in_space(at.first[0]) * offset[0] + in_space(at.first[1]) * offset[1] - in_space(bend);
    const double chord_square = chord.squaredNorm();
    if (chord_square > 0) {
      // Only the part across the chord counts, as long as the foot does not move beyond its ends.
      const double shift = sag.dot(chord) / chord_square;
      if (std::fabs(shift) < 1) sag -= chord * shift;
    }
    const auto& second = cell_->patch.second;
    double remainder = 0;
    for (long i = 0; i < 3; ++i) {
      const double slopes = std::fabs(at.first[0][i]) + std::fabs(at.first[1][i]);
      const double slope_changes = (second[0][i] + 2 * second[1][i] + second[2][i]) * reach;
      remainder = std::max(remainder, slopes * rest + slope_changes * (distance + rest) + 0.25 * bend_change[i]);
    }
    remainder += std::max(at.error, next.patch.error);
    return 0.125 * (sag.norm() + rounding * in_space(bend).norm()) + 1.74 * remainder;
  }

  /// Bounds the distance in space of the arc from here to the goal from its chord.
  std::optional<double> chord_error(const Vector2d& rest) {
    if (goal_.kind == SectionEnd::node)
      if (const auto error = chord_error_at_node(rest)) return error;
    return chord_error_in_box(rest);
  }

  std::optional<double> chord_error_at_node(const Vector2d& rest) {
    const double half = 1.25 * rest.lpNorm<Eigen::Infinity>() + goal_.radius;
    const Vector2d end(goal_.at[0], goal_.at[1]);
    if (!(half < 0.02)) return std::nullopt;
    const Vector2d low = (end.array() - half).max(-margin);
    const Vector2d high = (end.array() + half).min(1 + margin);
    if (!cover(low, high)) return std::nullopt;
    const Place goal = place_at(end);
    const Matrix2d hessian = goal.hessian();
    const auto directions = zero_directions(hessian);
    if (!directions) return std::nullopt;
    // Zeros with |b| <= |a| are within |b| <= slope |a| of a zero direction, one for each a.
    // How much the Hessian may change in the box; its rounding is far below the rest.
    const auto& third = cell_->f.third;
    const double noise = 1e-12 * hessian.cwiseAbs().maxCoeff();
    Matrix2d change;
    change << third[0][0] + third[1][0], third[1][0] + third[2][0], third[1][0] + third[2][0],
        third[2][0] + third[3][0];
    change = (change * (half + goal_.radius)).array() + noise;
    const auto bound = [&](long i, long j) {
      return directions->col(i).cwiseAbs().dot(change * directions->col(j).cwiseAbs());
    };
    const auto own = [&](long i) {
      return std::fabs(directions->col(i).dot(hessian * directions->col(i))) + bound(i, i);
    };
    const double mixed = std::fabs(directions->col(0).dot(hessian * directions->col(1))) - bound(0, 1);
    const Vector2d z = directions->inverse() * (here_.x - end);
    const long axis = std::fabs(z[0]) > std::fabs(z[1]) ? 0 : 1;
    const double slope = own(axis) / (2 * mixed - own(1 - axis));
    if (!(mixed > 0) || !(2 * mixed > own(1 - axis)) || !(slope < 0.05)) return std::nullopt;
    const double along_cone = std::fabs(z[axis]);
    const double across = slope * along_cone + 4 * goal_.radius / std::fabs(directions->determinant());
    // Clearly not in the other cone; next to the node doubles place it no better than that.
    const double off_direction = std::fabs(z[1 - axis]);
    if (!(off_direction < 0.05 * along_cone)) return std::nullopt;
    return in_space_within((across + off_direction) * directions->col(1 - axis).cwiseAbs(), rest.cwiseAbs());
  }

  /// The arc is the graph of a function of the first parameter, and f has no zero on the horizontal sides of a box.
  std::optional<double> chord_error_in_box(const Vector2d& rest) {
    if (!goal_.monotone || !(rest.lpNorm<Eigen::Infinity>() < 0.02)) return std::nullopt;
    const Vector2d end(goal_.at[0], goal_.at[1]);
    for (const double share : {0x1p-8, 0x1p-6, 0x1p-4, 0.25, 1.0, 4.0}) {
      const double more = share * rest.lpNorm<Eigen::Infinity>() + 2 * goal_.radius;
      const Vector2d slack(goal_.radius, more);
      const Vector2d low = here_.x.cwiseMin(end) - slack;
      const Vector2d high = here_.x.cwiseMax(end) + slack;
      const auto is_free = [&](double v) {
        return v < 0 || v > 1 || excludes_zero(function_, {std::max(0.0, low[0]), v}, {std::min(1.0, high[0]), v});
      };
      if (!is_free(low[1]) || !is_free(high[1])) continue;
      if (!cover(low.cwiseMax(0), high.cwiseMin(1))) return std::nullopt;
      // Compared above one u.
      return in_space_within({4 * goal_.radius, high[1] - low[1]}, rest.cwiseAbs());
    }
    return std::nullopt;
  }

  /// Of two curves whose parameters differ by `difference` at most, one of them a segment `d`.
  double in_space_within(const Vector2d& difference, const Vector2d& d) const {
    const DerivativeBounds& bounds = cell_->patch;
    double largest = 0;
    for (long i = 0; i < 3; ++i)
      largest = std::max(largest, bounds.first[0][i] * difference[0] + bounds.first[1][i] * difference[1] +
                                      0.125 * along(bounds.second, d[0], d[1])[i]);
    return 1.74 * largest + 2 * here_.patch.error;
  }

  void add(const Place& place) {
    SectionPoint point;
    for (std::size_t k = 0; k < 2; ++k) point.parameters[k] = std::clamp(place.x[static_cast<long>(k)], 0.0, 1.0);
    for (std::size_t k = 0; k < 3; ++k) point.point[k] = place.patch.point[static_cast<long>(k)];
    arc_.points.push_back(point);
  }

  PatchJets patch_;
  PatchJets f_;
  const ControlNet& function_;
  const SectionGoal& goal_;
  double tolerance_;
  double reach_;
  std::optional<Cell> cell_;
  Place here_;
  SectionArc arc_;
};

}  // namespace

SectionArc SectionTracer::trace(const SectionSeed& seed, const SectionGoal& goal, double tolerance, double reach,
                                const Context& context) const {
  return Tracing(patch_, function_, goal, tolerance, reach)
      .run({seed.at[0], seed.at[1]}, seed.radius, {seed.side[0], seed.side[1]}, context);
}

}  // namespace eliminant::bridge
