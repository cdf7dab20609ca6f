// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/cylinder_judgement.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <eliminant/numeric/cylinder_layer.hpp>

namespace eliminant::numeric {

namespace {

constexpr std::size_t sectors = 32;
constexpr double least_covered = 0.25;
// Scan lines along a pipe leave sectors without points between them; over such gaps one arc has to be long enough.
constexpr std::size_t longest_bridge = 2;
// Straight pipes gain less than a hundredth in generated scenes, pieces of elbows a fifth or more.
constexpr double largest_gain_by_bending = 1.1;
constexpr double largest_gain_by_deforming = 1.1;
constexpr int rounds_of_deforming = 8;
// In radii. A torus whose axis has the radius 3 r is within the distance of a cylinder over sqrt(36 r d).
constexpr double least_length = 1.5;

bool is_covered(std::span<const Point> points, const CylinderSegment& segment) {
  const CylinderFrame frame(segment.cylinder);
  std::array<std::size_t, sectors> counts{};
  for (const std::uint32_t i : segment.inliers) {
    const double turn = (frame.angle(points[i]) / std::numbers::pi + 1) / 2;
    ++counts[std::min(sectors - 1, static_cast<std::size_t>(turn * sectors))];
  }
  const double usual = usual_count(counts);
  const auto filled = [&](std::size_t sector) { return static_cast<double>(counts[sector % sectors]) >= usual / 4; };
  std::size_t covered = 0;
  std::size_t longest_run = 0;
  for (std::size_t first = 0; first < sectors; ++first) {
    if (!filled(first)) continue;
    ++covered;
    std::size_t last = first;
    for (std::size_t at = first + 1; at < first + sectors && at - last <= longest_bridge + 1; ++at)
      if (filled(at)) last = at;
    longest_run = std::max(longest_run, last - first + 1);
  }
  return static_cast<double>(std::max(covered, longest_run)) >= least_covered * sectors;
}

// The residuals near a segment as a combination of {1, h, h^2} x {1, cos, sin}, h from -1 to 1 along the segment: a
// tilted cone, sphere or torus to second order.
class BentSurface {
 public:
  using Shape = Eigen::Matrix<double, 9, 1>;

  BentSurface(std::span<const Point> points, const CylinderSegment& segment, double beyond) {
    const CylinderFrame frame(segment.cylinder);
    const double middle = (segment.lowest + segment.highest) / 2;
    for (const NearPoint& near :
         points_near(points, frame, segment.lowest - beyond, segment.highest + beyond, layers * segment.reach / 3)) {
      const Point& point = points[near.index];
      const double h = 2 * (near.height - middle) / segment.length();
      const double angle = frame.angle(point);
      const Eigen::Vector3d around(1, std::cos(angle), std::sin(angle));
      Shape row;
      row << around, h * around, h * h * around;
      rows_.push_back(row);
      residuals_.push_back(frame.at(point).residual);
    }
  }

  // Fitted to the points within `reach` of what `shape` says.
  Shape refit(const Shape& shape, double reach) const {
    Eigen::Matrix<double, 9, 9> normal = Eigen::Matrix<double, 9, 9>::Zero();
    Shape right = Shape::Zero();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (std::abs(residuals_[i] - rows_[i].dot(shape)) > reach) continue;
      normal += rows_[i] * rows_[i].transpose();
      right += residuals_[i] * rows_[i];
    }
    return normal.ldlt().solve(right);
  }

  std::size_t count_on(const Shape& shape, double reach) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      count += std::abs(residuals_[i] - rows_[i].dot(shape)) <= reach ? 1 : 0;
    return count;
  }

 private:
  static constexpr double layers = 8;
  std::vector<Shape> rows_;
  std::vector<double> residuals_;
};

// Whether no bent surface has many more points than the cylinder on and shortly beyond the segment.
bool is_straight(std::span<const Point> points, const CylinderSegment& segment) {
  const BentSurface surface(points, segment, std::min(segment.cylinder.radius, segment.length() / 4));
  BentSurface::Shape shape = BentSurface::Shape::Zero();
  const std::size_t straight = surface.count_on(shape, segment.reach);
  for (int i = 0; i < 5; ++i) shape = surface.refit(shape, 2 * segment.reach);
  const std::size_t bent = surface.count_on(shape, segment.reach);
  return static_cast<double>(bent) <= largest_gain_by_bending * static_cast<double>(straight);
}

// The residuals along a segment as a function of the angle, broken linear, and {h, h^2} x {1, cos, sin}, h from -1 to 1
// along the segment: any cross section, on an axis that is tilted and bends. Between two knots a plane departs from the
// cylinder by about an eighth of the reach.
class DeformedSurface {
 public:
  DeformedSurface(std::span<const Point> points, const CylinderSegment& segment) : reach_(segment.reach) {
    const CylinderFrame frame(segment.cylinder);
    const double wanted = 2 * std::numbers::pi * std::sqrt(segment.cylinder.radius / segment.reach);
    knots_ = static_cast<Eigen::Index>(std::clamp(wanted, least_knots, most_knots));
    shape_ = Eigen::VectorXd::Zero(knots_ + bends);
    const double middle = (segment.lowest + segment.highest) / 2;
    for (const NearPoint& near : points_near(points, frame, segment.lowest, segment.highest, layers * reach_ / 3)) {
      const double angle = frame.angle(points[near.index]);
      const double place = (angle / std::numbers::pi + 1) / 2 * static_cast<double>(knots_);
      const auto knot = std::min(knots_ - 1, static_cast<Eigen::Index>(place));
      const double beyond = place - static_cast<double>(knot);
      const double h = 2 * (near.height - middle) / segment.length();
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      rows_.push_back({near.residual,
                       {knot, (knot + 1) % knots_, knots_, knots_ + 1, knots_ + 2, knots_ + 3, knots_ + 4, knots_ + 5},
                       {1 - beyond, beyond, h, h * c, h * s, h * h, h * h * c, h * h * s}});
    }
  }

  // Fitted to the points within two reaches of what it is; where there are none it goes on as straight as it can.
  void refit() {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(shape_.size(), shape_.size());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(shape_.size());
    double used = 0;
    for (const Row& row : rows_) {
      if (std::abs(row.residual - offset_at(row)) > 2 * reach_) continue;
      used += 1;
      for (std::size_t i = 0; i < row.at.size(); ++i) {
        right[row.at[i]] += row.weight[i] * row.residual;
        for (std::size_t j = 0; j < row.at.size(); ++j) normal(row.at[i], row.at[j]) += row.weight[i] * row.weight[j];
      }
    }
    const double stiffness = stiffness_share * used / static_cast<double>(knots_);
    for (Eigen::Index k = 0; k < knots_; ++k) {
      const std::array<Eigen::Index, 3> at{k, (k + 1) % knots_, (k + 2) % knots_};
      constexpr std::array<double, 3> second_difference{1, -2, 1};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          normal(at[i], at[j]) += stiffness * second_difference[i] * second_difference[j];
    }
    for (Eigen::Index k = 0; k < bends; ++k) normal(knots_ + k, knots_ + k) += bend_share * used;
    shape_ = normal.ldlt().solve(right);
  }

  std::size_t count_on() const {
    return static_cast<std::size_t>(std::count_if(
        rows_.begin(), rows_.end(), [&](const Row& row) { return std::abs(row.residual - offset_at(row)) <= reach_; }));
  }

 private:
  static constexpr Eigen::Index bends = 6;
  static constexpr double layers = 8;
  static constexpr double least_knots = 12;
  static constexpr double most_knots = 96;
  // In points: of a knot's usual number, and of all.
  static constexpr double stiffness_share = 0.05;
  static constexpr double bend_share = 1e-3;

  // A residual and the numbers of the shape that make it up, with their factors.
  struct Row {
    double residual;
    std::array<Eigen::Index, 2 + bends> at;
    std::array<double, 2 + bends> weight;
  };

  double offset_at(const Row& row) const {
    double offset = 0;
    for (std::size_t i = 0; i < row.at.size(); ++i) offset += row.weight[i] * shape_[row.at[i]];
    return offset;
  }

  double reach_;
  Eigen::Index knots_ = 0;
  Eigen::VectorXd shape_;
  std::vector<Row> rows_;
};

// Whether no surface with another cross section has many more points than the cylinder.
bool is_round(std::span<const Point> points, const CylinderSegment& segment) {
  DeformedSurface surface(points, segment);
  const std::size_t round = surface.count_on();
  for (int i = 0; i < rounds_of_deforming; ++i) surface.refit();
  return static_cast<double>(surface.count_on()) <= largest_gain_by_deforming * static_cast<double>(round);
}

bool ends_at_its_sides(std::span<const Point> points, const CylinderSegment& segment) {
  const CylinderFrame frame(segment.cylinder);
  const std::size_t near = points_near(points, frame, segment.lowest, segment.highest, segment.reach).size();
  return ends_in_layer(segment.inliers.size(), near - segment.inliers.size());
}

}  // namespace

SegmentVerdict judge_segment(std::span<const Point> points, std::span<const Point> cloud,
                             const CylinderSegment& segment, const CylinderCriteria& criteria) {
  const double radius = segment.cylinder.radius;
  if (segment.inliers.size() < criteria.min_inliers) return SegmentVerdict::few_points;
  if (radius < criteria.min_radius || radius > criteria.max_radius) return SegmentVerdict::radius;
  if (segment.length() < least_length * radius) return SegmentVerdict::too_short;
  if (!is_covered(points, segment)) return SegmentVerdict::narrow;
  if (!is_straight(points, segment)) return SegmentVerdict::curved;
  if (!ends_at_its_sides(points, segment)) return SegmentVerdict::beside;
  if (!is_round(cloud, segment)) return SegmentVerdict::not_round;
  return SegmentVerdict::cylinder;
}

}  // namespace eliminant::numeric
