// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/pinch_point.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <eliminant/bridge/double_interval.hpp>
#include <eliminant/bridge/enclosed_patch.hpp>
#include <eliminant/bridge/patch_jets.hpp>
#include <eliminant/bridge/taylor_tables.hpp>

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

/// An arc of pairs x, x + k (e + m f), from one value of k to the next, by Newton's method on the divided difference.
class PinchArc {
 public:
  PinchArc(const ControlNet& net, double angle) : jets_(net), e_{std::cos(angle), std::sin(angle)}, f_{-e_[1], e_[0]} {}

  /// u, v, m.
  Vector3d solve(Vector3d x, double k) {
    constexpr int most_steps = 10;
    for (int step = 0; step < most_steps; ++step) {
      const double du = e_[0] + x[2] * f_[0];
      const double dv = e_[1] + x[2] * f_[1];
      const PatchJets::Value a = jets_.at(x[0], x[1]);
      const PatchJets::Value b = jets_.at(x[0] + k * du, x[1] + k * dv);
      Vector3d value;
      Matrix3d jacobian;
      if (std::fabs(k) > 1e-3) {
        value = vector_of(b.point - a.point) / k;
        jacobian.col(0) = vector_of(b.first[0] - a.first[0]) / k;
        jacobian.col(1) = vector_of(b.first[1] - a.first[1]) / k;
        jacobian.col(2) = vector_of(b.first[0] * f_[0] + b.first[1] * f_[1]);
      } else {
        // The derivative halfway, exact to second order.
        const PatchJets::Value c = jets_.at(x[0] + 0.5 * k * du, x[1] + 0.5 * k * dv);
        value = vector_of(c.first[0] * du + c.first[1] * dv);
        jacobian.col(0) = vector_of(c.second[0] * du + c.second[1] * dv);
        jacobian.col(1) = vector_of(c.second[1] * du + c.second[2] * dv);
        jacobian.col(2) = vector_of(c.first[0] * f_[0] + c.first[1] * f_[1]);
      }
      const Vector3d change = jacobian.partialPivLu().solve(value);
      if (!change.allFinite()) break;
      x -= change;
      if (change.lpNorm<Eigen::Infinity>() < 1e-14) break;
    }
    return x;
  }

  ParameterPair pair(const Vector3d& x, double k) const {
    return {x[0], x[1], x[0] + k * (e_[0] + x[2] * f_[0]), x[1] + k * (e_[1] + x[2] * f_[1])};
  }

  const std::array<double, 2>& e() const { return e_; }
  const std::array<double, 2>& f() const { return f_; }

 private:
  PatchJets jets_;
  std::array<double, 2> e_;
  std::array<double, 2> f_;
};

}  // namespace

std::optional<PinchPoint> pinch_point_in(const ControlNet& net, const ParameterRectangle& rectangle) {
  const auto singularity = find_singularity(net, rectangle);
  if (!singularity) return std::nullopt;
  const std::array<double, 2> at{singularity->u, singularity->v};
  for (std::size_t k = 0; k < 2; ++k) {
    constexpr double inside = 1e-9;
    if (!(at[k] > rectangle.lower[k] + inside && at[k] < rectangle.upper[k] - inside)) return std::nullopt;
    if (!(at[k] > inside && at[k] < 1 - inside)) return std::nullopt;
  }
  const PinchArc arc(net, singularity->angle);
  const auto& e = arc.e();
  const auto& f = arc.f();
  const PatchJets::Value middle = PatchJets(net).at(at[0], at[1]);

  ContactFrame frame;
  frame.origin = middle.point;
  frame.origin[3] = 0;
  for (long k = 0; k < 3; ++k) {
    Array4d column = Array4d::Zero();
    column[k] = 1;
    frame.columns[static_cast<std::size_t>(k)] = column;
  }
  const EnclosedPatch patch(taylor_on_box(
      net, frame, {{rectangle.lower[0], rectangle.lower[1], 0}, {rectangle.upper[0], rectangle.upper[1], 0}}, 0, 2));
  const Enclosed along_e = combination(patch.first[0], e[0], patch.first[1], e[1]);
  const Enclosed along_f = combination(patch.first[0], f[0], patch.first[1], f[1]);
  const auto second = [&](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return sum(combination(patch.second[0], a[0] * b[0], patch.second[1], a[0] * b[1] + a[1] * b[0]),
               DoubleInterval(a[1] * b[1]), patch.second[2]);
  };
  const Enclosed ee = second(e, e);
  const Enclosed ef = second(e, f);
  const Enclosed ff = second(f, f);

  // Pairs that differ by more than `slope` along f for 1 along e have different points.
  const Vector3d normal = vector_of(middle.first[0] * f[0] + middle.first[1] * f[1]).normalized();
  DoubleInterval rise(0);
  DoubleInterval drift(0);
  for (std::size_t k = 0; k < 3; ++k) {
    rise = rise + along_f[k] * DoubleInterval(normal[static_cast<long>(k)]);
    drift = drift + along_e[k] * DoubleInterval(normal[static_cast<long>(k)]);
  }
  if (!(rise.lower > 0)) return std::nullopt;
  const double slope = 1.001 * drift.magnitude() / rise.lower + 1e-9;
  const double reach = 1.001 * ((rectangle.upper[0] - rectangle.lower[0]) * std::fabs(e[0]) +
                                (rectangle.upper[1] - rectangle.lower[1]) * std::fabs(e[1]));
  const DoubleInterval m(-slope, slope);
  // The columns of the derivative of the divided difference by x along e and f, and by m.
  const std::array<Enclosed, 3> columns{sum(ee, m, ef), sum(ef, m, ff),
                                        sum(along_f, DoubleInterval(-0.5 * reach, 0.5 * reach), sum(ef, m, ff))};
  Matrix3d matrix;
  matrix.col(0) = vector_of(middle.second[0] * (e[0] * e[0]) + middle.second[1] * (2 * e[0] * e[1]) +
                            middle.second[2] * (e[1] * e[1]));
  matrix.col(1) = vector_of(middle.second[0] * (e[0] * f[0]) + middle.second[1] * (e[0] * f[1] + e[1] * f[0]) +
                            middle.second[2] * (e[1] * f[1]));
  matrix.col(2) = vector_of(middle.first[0] * f[0] + middle.first[1] * f[1]);
  const Matrix3d inverse = matrix.inverse();
  if (!inverse.allFinite()) return std::nullopt;
  double contraction = 0;
  for (long i = 0; i < 3; ++i) {
    double row = 0;
    for (long j = 0; j < 3; ++j) {
      DoubleInterval entry(i == j ? -1 : 0);
      for (long k = 0; k < 3; ++k)
        entry =
            entry + DoubleInterval(inverse(i, k)) * columns[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
      row += entry.magnitude();
    }
    contraction = std::max(contraction, row);
  }
  constexpr double at_most = 0.95;
  if (!(contraction < at_most)) return std::nullopt;

  // The zero at k = 0 is there: what is left of the derivative along e, and the error of evaluating it.
  const double norm = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  const Vector3d left = vector_of(middle.first[0] * e[0] + middle.first[1] * e[1]);
  double size = 0;
  for (const Array4d& point : net.points) size = std::max(size, point.abs().maxCoeff());
  const double degrees = static_cast<double>(net.degrees[0] + net.degrees[1]);
  const double rounding =
      64 * degrees * degrees * unit_roundoff * size * (1 + size) + 64 * degrees * net.error.maxCoeff();
  PinchPoint pinch;
  pinch.parameters = at;
  pinch.radius = norm * (left.lpNorm<Eigen::Infinity>() + rounding) / (1 - contraction);
  for (std::size_t k = 0; k < 2; ++k)
    if (!(at[k] - 2 * pinch.radius > rectangle.lower[k] && at[k] + 2 * pinch.radius < rectangle.upper[k]))
      return std::nullopt;
  const Enclosed bend = sum(sum(ee, DoubleInterval(2) * m, ef), m * m, ff);
  pinch.speed = 0.5 * norm * magnitude(bend) / (1 - contraction) * 1.001;
  pinch.space_speed = 1.75 * 1.001 * (magnitude(patch.first[0]) + magnitude(patch.first[1]));
  return pinch;
}

std::vector<ParameterPair> arc_to_pinch_point(const ControlNet& net, const PinchPoint& pinch, const ParameterPair& from,
                                              std::size_t count) {
  const auto singularity = find_singularity(net, {pinch.parameters, pinch.parameters});
  std::vector<ParameterPair> result;
  if (!singularity) return result;
  PinchArc arc(net, singularity->angle);
  const double du = from[2] - from[0];
  const double dv = from[3] - from[1];
  const double first = du * arc.e()[0] + dv * arc.e()[1];
  Vector3d x(from[0], from[1], first == 0 ? 0 : (du * arc.f()[0] + dv * arc.f()[1]) / first);
  for (std::size_t i = 1; i < count; ++i) {
    const double k = first * (1 - static_cast<double>(i) / static_cast<double>(count));
    x = arc.solve(x, k);
    result.push_back(arc.pair(x, k));
  }
  result.push_back({pinch.parameters[0], pinch.parameters[1], pinch.parameters[0], pinch.parameters[1]});
  return result;
}

}  // namespace eliminant::bridge
