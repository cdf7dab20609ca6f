// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/cylinder_fit.hpp>

#include <Eigen/Dense>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>

namespace eliminant::numeric {

namespace {

using Eigen::Vector3d;

Vector3d vector_of(const Point& point) { return {point[0], point[1], point[2]}; }
Point point_of(const Vector3d& vector) { return {vector[0], vector[1], vector[2]}; }

// Two directions that complete a unit vector to an orthonormal basis.
std::array<Vector3d, 2> normals_of(const Vector3d& direction) {
  Eigen::Index least = 0;
  direction.cwiseAbs().minCoeff(&least);
  const Vector3d u = direction.cross(Vector3d::Unit(least)).normalized();
  return {u, direction.cross(u)};
}

// The distances as functions of five numbers: the axis goes through m + p_2 u + p_3 v along e + p_0 u + p_1 v, where m
// is the foot of the points' mean on the axis of the start, (u, v, e) its frame; the radius is p_4.
class Distances {
 public:
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };  // NOLINT: names of Eigen

  Distances(std::span<const Point> points, const Cylinder& start)
      : local_(3, static_cast<Eigen::Index>(points.size())) {
    axis_ = vector_of(start.direction).normalized();
    const auto normals = normals_of(axis_);
    u_ = normals[0];
    v_ = normals[1];
    Vector3d mean = Vector3d::Zero();
    for (const Point& point : points) mean += vector_of(point);
    mean /= static_cast<double>(points.size());
    const Vector3d foot = vector_of(start.axis_point);
    middle_ = foot + axis_ * axis_.dot(mean - foot);
    for (Eigen::Index i = 0; i < local_.cols(); ++i) {
      const Vector3d point = vector_of(points[static_cast<std::size_t>(i)]) - middle_;
      local_.col(i) = Vector3d(u_.dot(point), v_.dot(point), axis_.dot(point));
    }
  }

  int inputs() const { return 5; }
  int values() const { return static_cast<int>(local_.cols()); }

  int operator()(const Eigen::VectorXd& p, Eigen::VectorXd& distances) const {
    const Vector3d e = Vector3d(p[0], p[1], 1).normalized();
    for (Eigen::Index i = 0; i < local_.cols(); ++i) distances[i] = offset(p, e, i).norm() - p[4];
    return 0;
  }

  int df(const Eigen::VectorXd& p, Eigen::MatrixXd& jacobian) const {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + 1);
    const Vector3d e = Vector3d(p[0], p[1], 1) / length;
    for (Eigen::Index i = 0; i < local_.cols(); ++i) {
      const Vector3d from_axis = offset(p, e, i);
      const double distance = from_axis.norm();
      const Vector3d normal = distance > 0 ? Vector3d(from_axis / distance) : Vector3d::UnitX();
      const double height = (local_.col(i) - Vector3d(p[2], p[3], 0)).dot(e) / length;
      jacobian.row(i) << -height * normal[0], -height * normal[1], -normal[0], -normal[1], -1;
    }
    return 0;
  }

  Cylinder cylinder(const Eigen::VectorXd& p) const {
    const Vector3d direction = (axis_ + p[0] * u_ + p[1] * v_).normalized();
    return {point_of(direction), point_of(middle_ + p[2] * u_ + p[3] * v_), std::abs(p[4])};
  }

 private:
  // From the axis to point i, orthogonal to the axis.
  Vector3d offset(const Eigen::VectorXd& p, const Vector3d& e, Eigen::Index i) const {
    const Vector3d point = local_.col(i) - Vector3d(p[2], p[3], 0);
    return point - e * e.dot(point);
  }

  Eigen::Matrix3Xd local_;
  Vector3d axis_;
  Vector3d u_;
  Vector3d v_;
  Vector3d middle_;
};

}  // namespace

CylinderFrame::CylinderFrame(const Cylinder& cylinder) : cylinder_(cylinder) {
  const Vector3d direction = vector_of(cylinder.direction).normalized();
  const auto normals = normals_of(direction);
  cylinder_.direction = point_of(direction);
  u_ = point_of(normals[0]);
  v_ = point_of(normals[1]);
}

CylinderCoordinates CylinderFrame::at(const Point& point) const {
  const Point& e = cylinder_.direction;
  const Point& a = cylinder_.axis_point;
  const double x = point[0] - a[0];
  const double y = point[1] - a[1];
  const double z = point[2] - a[2];
  const double height = x * e[0] + y * e[1] + z * e[2];
  const double across_x = x - height * e[0];
  const double across_y = y - height * e[1];
  const double across_z = z - height * e[2];
  const double across = std::sqrt(across_x * across_x + across_y * across_y + across_z * across_z);
  return {height, across - cylinder_.radius};
}

double CylinderFrame::angle(const Point& point) const {
  const Vector3d from_axis = vector_of(point) - vector_of(cylinder_.axis_point);
  return std::atan2(vector_of(v_).dot(from_axis), vector_of(u_).dot(from_axis));
}

Point CylinderFrame::axis_at(double height) const {
  return point_of(vector_of(cylinder_.axis_point) + height * vector_of(cylinder_.direction));
}

Cylinder fit_cylinder(std::span<const Point> points, const Cylinder& start) {
  if (points.size() < 5) return start;
  Distances distances(points, start);
  Eigen::LevenbergMarquardt<Distances> iteration(distances);
  // A hundredth of what any scan resolves is reached in a few steps.
  iteration.parameters.ftol = 1e-6;
  iteration.parameters.xtol = 1e-8;
  iteration.parameters.maxfev = 40;
  Eigen::VectorXd p = Eigen::VectorXd::Zero(5);
  p[4] = start.radius;
  iteration.minimize(p);
  return p.allFinite() ? distances.cylinder(p) : start;
}

double rms_distance(std::span<const Point> points, const Cylinder& cylinder) {
  const CylinderFrame frame(cylinder);
  double sum = 0;
  for (const Point& point : points) {
    const double residual = frame.at(point).residual;
    sum += residual * residual;
  }
  return points.empty() ? 0 : std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace eliminant::numeric
