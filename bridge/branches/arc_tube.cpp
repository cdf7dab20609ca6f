// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/arc_tube.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

namespace eliminant::bridge {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// By how much derivatives by each parameter multiply errors of points.
Vector4d steepness_of(const PatchDifference& patches, const DifferenceBounds& bounds) {
  Vector4d result;
  for (std::size_t k = 0; k < 4; ++k) {
    const PatchJets& patch = k < 2 ? patches.first() : patches.second();
    // The change of the weight, relative to it.
    const double of_weight = (k < 2 ? bounds.first : bounds.second).first[k % 2][3];
    result[static_cast<long>(k)] = 2 * static_cast<double>(patch.degree(k % 2)) + of_weight;
  }
  return result;
}

/// The change of the second derivative in the direction (p, q) from one end to the other, bounded.
Array4d third_along(const DerivativeBounds& bounds, double p, double q) {
  p = std::fabs(p);
  q = std::fabs(q);
  return bounds.third[0] * (p * p * p) + bounds.third[1] * (3 * p * p * q) + bounds.third[2] * (3 * p * q * q) +
         bounds.third[3] * (q * q * q);
}

/// The second derivative of F along parameters d.
Vector3d bend_along(const Difference& at, const Vector4d& d) {
  return space_part(along(at.first.second, d[0], d[1]) - along(at.second.second, d[2], d[3]));
}

/// The arc as a polynomial of degree five in the share of the way, from its value and two derivatives at both ends.
class QuinticArc {
 public:
  struct End {
    Vector4d value;
    Vector4d slope;
    Vector4d bend;
  };
  QuinticArc(const End& from, const End& to) : from_(from) {
    const Vector4d value = to.value - from.value - from.slope - 0.5 * from.bend;
    const Vector4d slope = to.slope - from.slope - from.bend;
    const Vector4d bend = to.bend - from.bend;
    cubic_ = 10 * value - 4 * slope + 0.5 * bend;
    quartic_ = -15 * value + 7 * slope - bend;
    quintic_ = 6 * value - 3 * slope + 0.5 * bend;
  }

  Vector4d at(double share) const {
    return from_.value + share * (from_.slope + share * (0.5 * from_.bend +
                                                         share * (cubic_ + share * (quartic_ + share * quintic_))));
  }

 private:
  End from_;
  Vector4d cubic_;
  Vector4d quartic_;
  Vector4d quintic_;
};

}  // namespace

ArcTube::ArcTube(const PatchDifference& patches, const DifferenceBounds& bounds, const Difference& here,
                 const Difference& next)
    : bounds_(bounds), here_(here), next_(next), d_(next.x - here.x) {
  unit_ = parameter_units(here);
  step_ = d_.cwiseQuotient(unit_);
  const double length = step_.lpNorm<Eigen::Infinity>();
  if (!(length > 0) || !(length < infinity)) return;
  Matrix4d system = here.jacobian * unit_.asDiagonal();
  scale_ = system.topRows<3>().cwiseAbs().maxCoeff();
  system.row(3) = step_.transpose() * (scale_ / step_.norm());
  inverse_ = system.inverse();
  if (!inverse_.allFinite()) return;
  // What derivatives by each parameter make of an error of the points.
  steepness_ = steepness_of(patches, bounds);
  point_error_ = std::max({here.first.error, here.second.error, next.first.error, next.second.error});
  const double slope_error = point_error_ * steepness_.cwiseProduct(unit_).sum();
  // Of products with the inverse, relative to the whole.
  rounding_ = inverse_.cwiseAbs().rowwise().sum().maxCoeff() * (256 * unit_roundoff * scale_ + slope_error) + 1e-12;
  bound_deviation();
}

void ArcTube::bound_deviation() {
  // The second derivatives along the chord, and by how much they change on it.
  const Array4d bend_a = along(here_.first.second, d_[0], d_[1]);
  const Vector3d bend = bend_along(here_, d_);
  const Array4d change_a = third_along(bounds_.first, d_[0], d_[1]);
  const Array4d change_b = third_along(bounds_.second, d_[2], d_[3]);
  const double bend_error = 2 * point_error_ * std::pow(steepness_.dot(d_.cwiseAbs()), 2);
  // Of the points that are taken for ends of the arc.
  const double ends = std::max(here_.at_most(), next_.at_most()) + bend_error;
  const Vector3d rest = 0.125 * space_part(change_a + change_b) + Vector3d::Constant(ends);
  const Eigen::Matrix<double, 4, 3> solve = inverse_.leftCols<3>();
  const Vector4d offset = solve * bend;
  const double offset_error = (solve.cwiseAbs() * rest).lpNorm<Eigen::Infinity>();
  const double largest_offset = 0.125 * offset.lpNorm<Eigen::Infinity>() * (1 + rounding_) + offset_error;
  const double radius = 2.5 * largest_offset;
  lower_ = here_.x.cwiseMin(next_.x) - radius * unit_;
  upper_ = here_.x.cwiseMax(next_.x) + radius * unit_;
  if (!((lower_.array() >= bounds_.lower.array()).all() && (upper_.array() <= bounds_.upper.array()).all())) return;
  reach_ = step_.cwiseAbs() + Vector4d::Constant(radius);
  change_ = change_of_jacobian();
  const double contraction = change_.solved.rowwise().sum().maxCoeff() + rounding_;
  constexpr double at_most = 0.55;
  if (!(contraction < at_most)) return;
  contraction_ = contraction;
  distance_factor_ = solve.cwiseAbs().rowwise().sum().maxCoeff() / (1 - contraction);
  const Vector3d slopes_within =
      here_.jacobian.topLeftCorner<3, 2>().cwiseAbs() * unit_.head<2>() + change_.plain.leftCols<2>().rowwise().sum();
  error_factor_ = 1.001 * std::sqrt(3.0) * (slopes_within.maxCoeff() * distance_factor_ + 1);
  const double distance = largest_offset / (1 - contraction);

  // In space: the bend of the arc, of which only the part across the chord counts, and what is left.
  const std::array<Vector3d, 2> slope{space_part(here_.first.first[0]) * unit_[0],
                                      space_part(here_.first.first[1]) * unit_[1]};
  const Vector3d chord = slope[0] * step_[0] + slope[1] * step_[1];
  Vector3d sag = slope[0] * offset[0] + slope[1] * offset[1] - space_part(bend_a);
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
                                (change_.plain(i, 0) + change_.plain(i, 1)) * distance + 0.125 * change_a[i] + ends);
  }
  deviation_ = 0.125 * (sag.norm() + rounding_ * bend.norm()) + 1.74 * remainder;
}

/// By the second derivatives at `here` and bounds of the third.
ArcTube::JacobianChange ArcTube::change_of_jacobian() const {
  const Eigen::Matrix<double, 4, 3> solve = inverse_.leftCols<3>();
  const Vector4d moved = reach_.cwiseProduct(unit_);
  JacobianChange change;
  for (long own = 0; own < 4; own += 2) {
    const auto& second = own == 0 ? here_.first.second : here_.second.second;
    const auto& third = own == 0 ? bounds_.first.third : bounds_.second.third;
    const double p = moved[own];
    const double q = moved[own + 1];
    for (long k = 0; k < 2; ++k) {
      const auto order = static_cast<std::size_t>(k);
      const double own_unit = unit_[own + k];
      const Vector3d by_p = space_part(second[order]) * (p * own_unit);
      const Vector3d by_q = space_part(second[order + 1]) * (q * own_unit);
      const Array4d rest =
          (third[order] * (p * p) + third[order + 1] * (2 * p * q) + third[order + 2] * (q * q)) * (0.5 * own_unit);
      const double rounded =
          2 * own_unit * point_error_ * steepness_[own + k] * (steepness_[own] * p + steepness_[own + 1] * q);
      const Vector3d bound = space_part(rest) + Vector3d::Constant(rounded);
      change.plain.col(own + k) = by_p.cwiseAbs() + by_q.cwiseAbs() + bound;
      change.solved.col(own + k) = (solve * by_p).cwiseAbs() + (solve * by_q).cwiseAbs() + solve.cwiseAbs() * bound;
    }
  }
  return change;
}

/// Bounds by how much P''(w, w) of a patch changes from `here`, w being `along`, to any point of the tube, w being
/// within `error` of that; both in parameters and not negative.
Vector3d ArcTube::change_of_bend(const Vector4d& along, const Vector4d& error, std::size_t patch) const {
  const auto own = static_cast<long>(2 * patch);
  const auto& second = patch == 0 ? here_.first.second : here_.second.second;
  const auto& third = patch == 0 ? bounds_.first.third : bounds_.second.third;
  const double p = reach_[own] * unit_[own];
  const double q = reach_[own + 1] * unit_[own + 1];
  const double a = along[own] + error[own];
  const double b = along[own + 1] + error[own + 1];
  const Array4d other_point = third[0] * (p * a * a) + third[1] * (q * a * a + 2 * p * a * b) +
                              third[2] * (2 * q * a * b + p * b * b) + third[3] * (q * b * b);
  // Of a^2, a b and b^2.
  const double aa = error[own] * (a + along[own]);
  const double ab = a * error[own + 1] + error[own] * along[own + 1];
  const double bb = error[own + 1] * (b + along[own + 1]);
  const Array4d other_direction = second[0].abs() * aa + second[1].abs() * (2 * ab) + second[2].abs() * bb;
  const double rounded = 2 * point_error_ * std::pow(steepness_[own] * a + steepness_[own + 1] * b, 2);
  return space_part(other_point + other_direction) + Vector3d::Constant(rounded);
}

/// Bounds the part of the second derivative of the arc in space, by the share of the way, that is across any of its
/// chords; nullopt where a chord could turn so far that the feet of points might be beyond its ends.
std::optional<ArcTube::Bend> ArcTube::bend_across() const {
  const Eigen::Matrix<double, 4, 3> solve = inverse_.leftCols<3>();
  // y' is this, and changes by this.
  const Vector4d slope = inverse_.col(3) * (scale_ * step_.norm());
  const Matrix4d change = change_.solved + Matrix4d::Constant(0.25 * rounding_);
  const Vector4d first_change = change * slope.cwiseAbs();
  const Vector4d slope_change =
      first_change + change * Vector4d::Constant(first_change.maxCoeff() / (1 - contraction_));
  const Vector4d in_parameters = slope.cwiseProduct(unit_);
  const Vector4d change_in_parameters = slope_change.cwiseProduct(unit_);

  // -y'' is this, and changes by this.
  const Vector4d bend = solve * bend_along(here_, in_parameters);
  const Vector3d change_a = change_of_bend(in_parameters.cwiseAbs(), change_in_parameters, 0);
  const Vector3d change_b = change_of_bend(in_parameters.cwiseAbs(), change_in_parameters, 1);
  const Vector4d second_change = solve.cwiseAbs() * (change_a + change_b) + change * bend.cwiseAbs();
  const Vector4d bend_change =
      second_change + change * Vector4d::Constant(second_change.maxCoeff() / (1 - contraction_));

  // In space.
  const std::array<Vector3d, 2> slopes{space_part(here_.first.first[0]) * unit_[0],
                                       space_part(here_.first.first[1]) * unit_[1]};
  const Vector3d direction = slopes[0] * slope[0] + slopes[1] * slope[1];
  const Vector3d curving = space_part(along(here_.first.second, in_parameters[0], in_parameters[1])) -
                           slopes[0] * bend[0] - slopes[1] * bend[1];
  Vector3d curving_change = change_a;
  for (long k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    curving_change += slopes[i].cwiseAbs() * bend_change[k];
    curving_change += change_.plain.col(k) * (std::fabs(bend[k]) + bend_change[k]);
  }
  const double speed = direction.norm();
  const double largest = curving.norm() + curving_change.norm();
  // The sine of the angle between any two tangents or chords is at most about that.
  const double turn = largest / speed;
  if (!(turn < 0.5)) return std::nullopt;
  const double onward = curving.dot(direction) / speed;
  const double across = (curving - direction * (onward / speed)).norm();
  constexpr double slack = 1.001;
  return Bend{across, slack * (across + 1.1 * turn * std::fabs(onward) + curving_change.norm())};
}

std::optional<ArcTube::Placed> ArcTube::place(PatchDifference& patches, const Vector4d& guess) const {
  Vector4d x = guess;
  constexpr int most_steps = 4;
  for (int round = 0; round < most_steps; ++round) {
    Difference at = patches.slopes_at(x);
    double rest = at.value.abs().head<3>().maxCoeff();
    if (rest > 0.5 * at.error) {
      Matrix4d system = at.jacobian * unit_.asDiagonal();
      system.row(3) = step_.transpose() * (scale_ / step_.norm());
      const Vector4d change = -(system.inverse().leftCols<3>() * space_part(at.value)).cwiseProduct(unit_);
      x += change;
      const Array4d beyond = along(bounds_.first.second, std::fabs(change[0]), std::fabs(change[1])) +
                             along(bounds_.second.second, std::fabs(change[2]), std::fabs(change[3]));
      rest = 0.5 * beyond.head<3>().maxCoeff();
      // Not small enough to be left out.
      if (!(rest < 0.125 * at.error)) continue;
      at.x = x;
      at.first.point += at.first.first[0] * change[0] + at.first.first[1] * change[1];
      const Vector3d left = space_part(at.value) + at.jacobian.topRows<3>() * change;
      rest += left.lpNorm<Eigen::Infinity>() + 64 * unit_roundoff * at.value.abs().head<3>().maxCoeff();
    }
    rest += at.error;
    const Vector4d near = (distance_factor_ * rest) * unit_;
    if (((at.x - near).array() < lower_.array()).any() || ((at.x + near).array() > upper_.array()).any())
      return std::nullopt;
    return Placed{at, error_factor_ * rest};
  }
  return std::nullopt;
}

std::optional<ArcTube::Filling> ArcTube::fill(PatchDifference& patches, double tolerance) const {
  if (!proven()) return std::nullopt;
  const std::optional<Bend> bend = bend_across();
  if (!bend) return std::nullopt;
  // Shares are met within a hundredth of their differences; a tenth is left for errors of points.
  const auto chords = [&](double across) { return 1.01 * std::sqrt(0.125 * across / (0.9 * tolerance)); };
  const double wanted = std::max(std::ceil(chords(bend->at_most)), 1.0);
  constexpr double most_chords = 1 << 16;
  if (!(wanted < most_chords)) return std::nullopt;
  const auto count = static_cast<std::size_t>(wanted);

  const auto end = [&](const Difference& at, const Vector4d& value) {
    Matrix4d system = at.jacobian * unit_.asDiagonal();
    system.row(3) = step_.transpose() * (scale_ / step_.norm());
    const Matrix4d inverse = system.inverse();
    const Vector4d slope = inverse.col(3) * (scale_ * step_.norm());
    const Vector4d bend = -(inverse.leftCols<3>() * bend_along(at, slope.cwiseProduct(unit_)));
    return QuinticArc::End{value, slope, bend};
  };
  const QuinticArc arc(end(here_, Vector4d::Zero()), end(next_, step_));
  Filling filling;
  filling.spare = wanted - chords(bend->at_begin);
  filling.points.reserve(count);
  double error = error_factor_ * std::max(here_.at_most(), next_.at_most());
  for (std::size_t i = 1; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    const std::optional<Placed> placed = place(patches, here_.x + arc.at(share).cwiseProduct(unit_));
    if (!placed) return std::nullopt;
    error = std::max(error, placed->error);
    filling.points.push_back(placed->at);
  }
  filling.deviation = 0.125 * bend->at_most * std::pow(1.01 / static_cast<double>(count), 2) + error;
  if (!(filling.deviation < tolerance)) return std::nullopt;
  return filling;
}

}  // namespace eliminant::bridge
