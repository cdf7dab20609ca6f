// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/pinch_point.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/enclosed_patch.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

namespace eliminant::bridge {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector_of(const Array4d& a) { return {a[0], a[1], a[2]}; }

/// Where the derivative vanishes along (cos, sin) of an angle.
struct Singularity {
  double u = 0;
  double v = 0;
  double angle = 0;
};

std::optional<Singularity> find_singularity(const ControlNet& net, const ParameterRectangle& rectangle) {
  PatchJets jets(net);
  Singularity x{0.5 * (rectangle.lower[0] + rectangle.upper[0]), 0.5 * (rectangle.lower[1] + rectangle.upper[1]), 0};
  {
    // The direction in which the middle's derivative is smallest.
    const PatchJets::Value at = jets.at(x.u, x.v);
    const Vector3d a = vector_of(at.first[0]);
    const Vector3d b = vector_of(at.first[1]);
    x.angle = 0.5 * std::atan2(2 * a.dot(b), a.squaredNorm() - b.squaredNorm()) + std::acos(0.0);
  }
  constexpr int most_steps = 20;
  double last_step = INFINITY;
  for (int step = 0; step < most_steps && last_step > 1e-14; ++step) {
    if (!(x.u > -0.02 && x.u < 1.02 && x.v > -0.02 && x.v < 1.02)) return std::nullopt;
    const PatchJets::Value at = jets.at(x.u, x.v);
    const double c = std::cos(x.angle);
    const double s = std::sin(x.angle);
    Matrix3d jacobian;
    jacobian.col(0) = vector_of(at.second[0] * c + at.second[1] * s);
    jacobian.col(1) = vector_of(at.second[1] * c + at.second[2] * s);
    jacobian.col(2) = vector_of(at.first[1] * c - at.first[0] * s);
    const Vector3d change = jacobian.partialPivLu().solve(vector_of(at.first[0] * c + at.first[1] * s));
    if (!change.allFinite()) return std::nullopt;
    x.u -= change[0];
    x.v -= change[1];
    x.angle -= change[2];
    last_step = change.lpNorm<Eigen::Infinity>();
  }
  if (!(last_step < 1e-9)) return std::nullopt;
  return x;
}

/// Enclosures of derivatives along e and f.
using Enclosed = EnclosedPatch::Point;

Enclosed combination(const Enclosed& a, double p, const Enclosed& b, double q) {
  Enclosed result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = a[k] * DoubleInterval(p) + b[k] * DoubleInterval(q);
  return result;
}

Enclosed sum(const Enclosed& a, const DoubleInterval& factor, const Enclosed& b) {
  Enclosed result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = a[k] + factor * b[k];
  return result;
}

double magnitude(const Enclosed& a) { return std::max({a[0].magnitude(), a[1].magnitude(), a[2].magnitude()}); }

/// Derivatives along e and f for all points of a rectangle.
struct DirectionalDerivatives {
  Enclosed along_e;
  Enclosed along_f;
  Enclosed ee;
  Enclosed ef;
  Enclosed ff;

  DirectionalDerivatives(const ControlNet& net, const ContactFrame& frame, const ParameterRectangle& rectangle,
                         const std::array<double, 2>& e, const std::array<double, 2>& f) {
    const EnclosedPatch patch(taylor_on_box(
        net, frame, {{rectangle.lower[0], rectangle.lower[1], 0}, {rectangle.upper[0], rectangle.upper[1], 0}}, 0, 2));
    along_e = combination(patch.first[0], e[0], patch.first[1], e[1]);
    along_f = combination(patch.first[0], f[0], patch.first[1], f[1]);
    const auto second = [&](const std::array<double, 2>& a, const std::array<double, 2>& b) {
      return sum(combination(patch.second[0], a[0] * b[0], patch.second[1], a[0] * b[1] + a[1] * b[0]),
                 DoubleInterval(a[1] * b[1]), patch.second[2]);
    };
    ee = second(e, e);
    ef = second(e, f);
    ff = second(f, f);
  }
};

/// The divided difference (Phi(x + k (e + m f)) - Phi(x)) / k for all pairs of a rectangle: its derivative by x along e
/// and f and by m, against that at the pinch point with k = 0. All in coordinates in which the latter is the identity,
/// so that the position of the surface in space does not matter.
class DividedDifference {
 public:
  DividedDifference(const ControlNet& net, const Singularity& at, const ParameterRectangle& rectangle)
      : net_(net),
        rectangle_(rectangle),
        e_{std::cos(at.angle), std::sin(at.angle)},
        f_{-e_[1], e_[0]},
        middle_(PatchJets(net).at(at.u, at.v)) {
    length_ = 1.001 * ((rectangle.upper[0] - rectangle.lower[0]) * std::fabs(e_[0]) +
                       (rectangle.upper[1] - rectangle.lower[1]) * std::fabs(e_[1]));
  }

  /// Finds the directions in which there may be double points, and how far the derivative is from that at the pinch
  /// point. False when these are all directions or the latter is singular.
  bool bound() {
    Matrix3d matrix;
    matrix.col(0) = vector_of(along(middle_.second, e_[0], e_[1]));
    matrix.col(1) =
        vector_of(middle_.second[0] * (e_[0] * f_[0]) + middle_.second[1] * (e_[0] * f_[1] + e_[1] * f_[0]) +
                  middle_.second[2] * (e_[1] * f_[1]));
    matrix.col(2) = vector_of(middle_.first[0] * f_[0] + middle_.first[1] * f_[1]);
    inverse_ = matrix.inverse();
    if (!inverse_.allFinite()) return false;
    const DirectionalDerivatives d(net_, frame_of(inverse_), rectangle_, e_, f_);
    constexpr std::size_t last = 2;
    if (!(d.along_f[last].lower > 0)) return false;
    // Pairs that differ by more than that along f for 1 along e have different points.
    slope_ = 1.001 * d.along_e[last].magnitude() / d.along_f[last].lower + 1e-9;
    const DoubleInterval m(-slope_, slope_);
    const std::array<Enclosed, 3> columns{
        sum(d.ee, m, d.ef), sum(d.ef, m, d.ff),
        sum(d.along_f, DoubleInterval(-0.5 * length_, 0.5 * length_), sum(d.ef, m, d.ff))};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        deviation_(static_cast<long>(i), static_cast<long>(j)) =
            (columns[j][i] - DoubleInterval(i == j ? 1 : 0)).magnitude();
    bend_ = sum(sum(d.ee, DoubleInterval(2) * m, d.ef), m * m, d.ff);
    return is_contraction();
  }

  /// How far the zero at k = 0 is from the point found at most, along e and f.
  std::array<double, 2> error_of_zero(double rounding) const {
    const Vector3d left = vector_of(middle_.first[0] * e_[0] + middle_.first[1] * e_[1]).cwiseAbs();
    const Vector3d error = bound_of(inverse_.cwiseAbs() * (left + Vector3d::Constant(rounding)));
    return {error[0], error[1]};
  }

  /// How far from the pinch point, along e and f, the middle of two double points is for |k| = 1, at most: by the mean
  /// value theorem x(k) - x(0) is -1/2 the bend, solved for. nullopt where pairs on the way to k = 0 leave the
  /// rectangle, of which `margin` was added around the pairs asked for.
  std::optional<std::array<double, 2>> drift_of_middle(double margin) const {
    if (!(2 * slope_ * length_ < margin)) return std::nullopt;
    const Vector3d half_bend = 0.5 * Vector3d(bend_[0].magnitude(), bend_[1].magnitude(), bend_[2].magnitude());
    const Vector3d unsure = deviation_ * bound_of(half_bend);
    const DoubleInterval by_e = DoubleInterval(0.5) - DoubleInterval(0.5) * bend_[0];
    const DoubleInterval by_f = DoubleInterval(0.5) * bend_[1];
    // The second point is k m further along f.
    return std::array<double, 2>{1.001 * (by_e.magnitude() + unsure[0]),
                                 1.001 * (by_f.magnitude() + unsure[1] + 0.5 * slope_)};
  }

  /// Bounds the distance in space from the pinch point of the double points with |k| <= `length`.
  double reach(double length, const std::array<double, 2>& zero_error) const {
    // The derivative of x and m by k is -1/2 the bend, solved for with the whole matrix.
    const Vector3d speed = bound_of(0.5 * Vector3d(bend_[0].magnitude(), bend_[1].magnitude(), bend_[2].magnitude()));
    const double by_e = length * speed[0] + zero_error[0];
    const double by_f = length * speed[1] + zero_error[1];
    const Vector3d left = vector_of(middle_.first[0] * e_[0] + middle_.first[1] * e_[1]);
    const DirectionalDerivatives d(net_, frame_of(Matrix3d::Identity()), rectangle_, e_, f_);
    double result = 0;
    for (std::size_t k = 0; k < 3; ++k)
      result = std::max(result, (std::fabs(left[static_cast<long>(k)]) + 1e-14 * magnitude(d.along_f)) * by_e +
                                    d.along_f[k].magnitude() * by_f + 0.5 * d.ee[k].magnitude() * by_e * by_e +
                                    d.ef[k].magnitude() * by_e * by_f + 0.5 * d.ff[k].magnitude() * by_f * by_f);
    return 1.75 * result;
  }

 private:
  ContactFrame frame_of(const Matrix3d& matrix) const {
    ContactFrame frame;
    frame.origin = middle_.point;
    frame.origin[3] = 0;
    for (long k = 0; k < 3; ++k)
      frame.columns[static_cast<std::size_t>(k)] = Array4d(matrix(0, k), matrix(1, k), matrix(2, k), 0);
    return frame;
  }

  /// Whether the deviation shrinks all vectors in a maximum norm with weights, so that the whole is regular. Weights
  /// follow from its own powers: along e, along f and m are on scales of their own.
  bool is_contraction() {
    if (!deviation_.allFinite()) return false;
    Vector3d weights = Vector3d::Ones();
    constexpr int rounds = 12;
    for (int i = 0; i < rounds; ++i) {
      weights = deviation_ * weights + 1e-3 * weights;
      weights /= weights.maxCoeff();
    }
    const double contraction = (deviation_ * weights).cwiseQuotient(weights).maxCoeff();
    constexpr double at_most = 0.95;
    if (!(contraction < at_most)) return false;
    solved_ = 1.001 * (Matrix3d::Identity() - deviation_).inverse();
    return true;
  }

  /// Of all x with |x| <= b + D |x|, coordinate by coordinate, D the deviation.
  Vector3d bound_of(const Vector3d& b) const { return solved_ * b; }

  const ControlNet& net_;
  ParameterRectangle rectangle_;
  std::array<double, 2> e_;
  std::array<double, 2> f_;
  PatchJets::Value middle_;
  Enclosed bend_;
  /// Largest |k| of a pair in the rectangle, and largest |m| of double points.
  double length_ = 0;
  double slope_ = 0;
  Matrix3d inverse_;
  /// Bounds how much each entry of the derivative differs from that of the identity.
  Matrix3d deviation_ = Matrix3d::Zero();
  /// The inverse of the identity minus that, whose entries are not negative.
  Matrix3d solved_ = Matrix3d::Identity();
};

/// Of first derivatives in doubles: in proportion to the coordinates, which are small where the patch is.
double rounding_of(const ControlNet& net) {
  double size = 0;
  double least_weight = INFINITY;
  double largest_weight = 0;
  for (const Array4d& point : net.points) {
    size = std::max(size, point.abs().head<3>().maxCoeff());
    least_weight = std::min(least_weight, point[3]);
    largest_weight = std::max(largest_weight, point[3]);
  }
  const double degrees = static_cast<double>(net.degrees[0] + net.degrees[1]);
  const double by_weights = std::pow(1 + largest_weight / least_weight, 2);
  const double errors = net.error.head<3>().maxCoeff() + net.error[3] * size / least_weight;
  return 64 * degrees * by_weights * (degrees * unit_roundoff * size + errors) / least_weight;
}

}  // namespace

std::optional<PinchPoint> pinch_point_in(const ControlNet& net, const ParameterRectangle& rectangle) {
  const auto singularity = find_singularity(net, rectangle);
  if (!singularity) return std::nullopt;
  PinchPoint pinch;
  pinch.parameters = {singularity->u, singularity->v};
  pinch.angle = singularity->angle;
  DividedDifference difference(net, *singularity, rectangle);
  if (!difference.bound()) return std::nullopt;
  pinch.errors = difference.error_of_zero(rounding_of(net));
  pinch.radius = std::hypot(pinch.errors[0], pinch.errors[1]);
  for (std::size_t k = 0; k < 2; ++k) {
    const double margin = 2 * pinch.radius + 1e-12;
    const double at = pinch.parameters[k];
    if (!(at - margin > std::max(0.0, rectangle.lower[k]) && at + margin < std::min(1.0, rectangle.upper[k])))
      return std::nullopt;
  }
  return pinch;
}

bool is_off_arc(const ControlNet& net, const PinchPoint& pinch, const ParameterRectangle& first,
                const ParameterRectangle& second) {
  ParameterRectangle rectangle;
  double size = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double at = pinch.parameters[k];
    rectangle.lower[k] = std::min({at - pinch.radius, first.lower[k], second.lower[k]});
    rectangle.upper[k] = std::max({at + pinch.radius, first.upper[k], second.upper[k]});
    size = std::max(size, rectangle.upper[k] - rectangle.lower[k]);
  }
  const double margin = 0.25 * size;
  for (std::size_t k = 0; k < 2; ++k) {
    rectangle.lower[k] -= margin;
    rectangle.upper[k] += margin;
  }
  DividedDifference difference(net, {pinch.parameters[0], pinch.parameters[1], pinch.angle}, rectangle);
  if (!difference.bound()) return false;
  const auto drift = difference.drift_of_middle(margin);
  if (!drift) return false;
  const std::array<double, 2> e{std::cos(pinch.angle), std::sin(pinch.angle)};
  const auto along = [&](const ParameterRectangle& r, const std::array<double, 2>& direction) {
    DoubleInterval sum(0);
    for (std::size_t k = 0; k < 2; ++k)
      sum = sum + DoubleInterval(direction[k]) *
                      (DoubleInterval(r.lower[k], r.upper[k]) - DoubleInterval(pinch.parameters[k]));
    return sum;
  };
  const double k = (along(second, e) - along(first, e)).magnitude();
  for (std::size_t c = 0; c < 2; ++c) {
    const std::array<double, 2> direction = c == 0 ? e : std::array<double, 2>{-e[1], e[0]};
    const DoubleInterval middle = DoubleInterval(0.5) * (along(first, direction) + along(second, direction));
    const double most = (*drift)[c] * k + pinch.errors[c] + 1e-12;
    if (middle.lower > most || middle.upper < -most) return true;
  }
  return false;
}

std::optional<double> reach_of_pinch_point(const ControlNet& net, const PinchPoint& pinch, double near) {
  ParameterRectangle rectangle;
  for (std::size_t k = 0; k < 2; ++k) {
    rectangle.lower[k] = pinch.parameters[k] - near;
    rectangle.upper[k] = pinch.parameters[k] + near;
  }
  DividedDifference difference(net, {pinch.parameters[0], pinch.parameters[1], pinch.angle}, rectangle);
  if (!difference.bound()) return std::nullopt;
  // Both parameters of a pair are in the rectangle.
  constexpr double diagonal = 3;
  return difference.reach(diagonal * near, pinch.errors);
}

}  // namespace eliminant::bridge
