// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>

#include <eliminant/intersect/cylinders/cylinder_search.hpp>

namespace eliminant::intersect {

namespace {

using numeric::CylinderFrame;
using numeric::CylinderSegment;
using numeric::Point;

constexpr double least_radius_in_distances = 5;
// The shortest pipe that is looked for, one and a half radii long, alone in its cloud: 0.312.
constexpr double largest_radius_in_diagonals = 0.32;
constexpr double fewest_inliers_share = 0.002;
constexpr std::size_t fewest_inliers = 50;
constexpr std::size_t most_points = std::size_t{1} << 31U;
constexpr std::size_t most_points_of_fit = 50000;
// What the last fit leaves out at each end: the smaller of the two.
constexpr double end_in_radii = 0.75;
constexpr double end_in_lengths = 0.125;

struct PointBox {
  Point lowest;
  Point highest;
};

PointBox box_of(const std::vector<Point>& points) {
  PointBox box{};
  box.lowest.fill(std::numeric_limits<double>::max());
  box.highest.fill(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(points[i][k]))
        throw InvalidInput("point " + std::to_string(i + 1) + " is not finite", "points with finite coordinates");
      box.lowest[k] = std::min(box.lowest[k], points[i][k]);
      box.highest[k] = std::max(box.highest[k], points[i][k]);
    }
  if (points.empty()) box = {};
  return box;
}

// The box of all points but the farthest hundredth on each side, widened by its own size: a few points that are very
// far away say nothing of the size of the scene.
PointBox typical_box(const std::vector<Point>& points, const PointBox& whole) {
  PointBox box = whole;
  std::vector<double> values(points.size());
  const std::size_t rank = points.size() / 100;
  for (std::size_t k = 0; k < 3 && rank > 0; ++k) {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i][k];
    const auto low = values.begin() + static_cast<std::ptrdiff_t>(rank);
    const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), low, values.end());
    std::nth_element(low, high, values.end());
    const double width = *high - *low;
    if (!(width > 0) || !std::isfinite(width)) continue;
    box.lowest[k] = std::max(box.lowest[k], *low - width);
    box.highest[k] = std::min(box.highest[k], *high + width);
  }
  return box;
}

void require_positive(double value, const char* name) {
  if (!(value > 0) || !std::isfinite(value))
    throw InvalidInput(std::string(name) + " is not positive", "a positive number in the unit of the points");
}

class Extraction {
 public:
  Extraction(const CylinderExtractionProblem& problem, const Options& options) : problem_(problem), options_(options) {
    result_.cloud = problem.cloud;
    result_.warnings = problem.warnings;
    result_.seed = options.seed;
    result_.counts.points = problem.points.size();
    prepare();
  }

  CylinderExtractionResult run(const Context& context) {
    CylinderSearch search(distinct_, settings_);
    try {
      search.run(context);
    } catch (const LimitReached& limit) {
      result_.status = Status::incomplete;
      result_.limit = limit.what();
    }
    mark("search");
    segments_ = search.found();
    merge_pieces();
    label_points();
    refine();
    choose_points();
    list_cylinders();
    result_.confidence = search.confidence();
    result_.counts.samples = search.samples();
    result_.counts.candidates = search.candidates();
    mark("refinement");
    result_.seconds.insert(result_.seconds.begin(), {"total", seconds_since(start_)});
    return std::move(result_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  void mark(const char* stage) {
    result_.seconds.emplace_back(stage, seconds_since(stage_));
    stage_ = Clock::now();
  }

  // In the order of their first copies. Copies say nothing of a surface; many of few points look like one.
  std::vector<Point> distinct_points() {
    std::vector<std::uint32_t> order(points_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return std::tie(points_[a], a) < std::tie(points_[b], b); });
    is_copy_.assign(points_.size(), false);
    for (std::size_t k = 1; k < order.size(); ++k) is_copy_[order[k]] = points_[order[k]] == points_[order[k - 1]];
    std::vector<Point> result;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (!is_copy_[i]) result.push_back(points_[i]);
    return result;
  }

  // Checks the problem, chooses what it leaves open, moves the points around the origin and takes them in the unit.
  void prepare() {
    require_positive(problem_.distance, "the distance");
    if (!(problem_.confidence > 0) || !(problem_.confidence < 1))
      throw InvalidInput("the confidence is not between 0 and 1", "a number between 0 and 1, such as 0.99");
    if (problem_.points.size() > most_points) throw LimitReached("the cloud has more than 2^31 points");
    const PointBox box = typical_box(problem_.points, box_of(problem_.points));
    double diagonal = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      center_[k] = box.lowest[k] / 2 + box.highest[k] / 2;
      diagonal = std::hypot(diagonal, box.highest[k] - box.lowest[k]);
    }
    if (!std::isfinite(diagonal)) throw InvalidInput("the cloud is too large for doubles", "coordinates below 1e300");
    unit_ = std::ldexp(1.0, std::ilogb(problem_.distance));
    constexpr double finest = 0x1p52;
    if (!(diagonal / unit_ < finest))
      throw InvalidInput("the distance is smaller than doubles tell points of this cloud apart", "a larger distance");
    numeric::CylinderCriteria& criteria = settings_.criteria;
    criteria.distance = problem_.distance;
    criteria.min_radius = problem_.min_radius.value_or(least_radius_in_distances * problem_.distance);
    criteria.max_radius =
        problem_.max_radius.value_or(std::max(criteria.min_radius, largest_radius_in_diagonals * diagonal));
    require_positive(criteria.min_radius, "min_radius");
    require_positive(criteria.max_radius, "max_radius");
    if (criteria.min_radius > criteria.max_radius)
      throw InvalidInput("min_radius is larger than max_radius", "min_radius <= max_radius");
    settings_.confidence = problem_.confidence;
    settings_.seed = options_.seed;
    settings_.threads = options_.threads;
    // What is far outside stays far outside.
    constexpr double far = 16;
    std::size_t moved = 0;
    for (Point point : problem_.points) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const double place = point[k] - center_[k];
        const double kept = std::clamp(place, -far * diagonal, far * diagonal);
        inside = inside && kept == place;
        point[k] = kept / unit_;
      }
      if (!inside) ++moved;
      points_.push_back(point);
    }
    if (moved > 0)
      result_.warnings.push_back(std::to_string(moved) + (moved == 1 ? " point is" : " points are") +
                                 " very far from all others, of no cylinder");
    distinct_ = distinct_points();
    const double share = std::ceil(fewest_inliers_share * static_cast<double>(distinct_.size()));
    criteria.min_inliers = problem_.min_inliers.value_or(std::max(fewest_inliers, static_cast<std::size_t>(share)));
    result_.distance = criteria.distance;
    result_.min_radius = criteria.min_radius;
    result_.max_radius = criteria.max_radius;
    result_.min_inliers = criteria.min_inliers;
    for (double* const length : {&criteria.distance, &criteria.min_radius, &criteria.max_radius}) *length /= unit_;
  }

  // What was found in two pieces becomes one: the same cylinder, with a gap no longer than its radius.
  void merge_pieces() {
    for (std::size_t i = 0; i < segments_.size(); ++i)
      for (std::size_t j = i + 1; j < segments_.size();) {
        if (!joins(segments_[i], segments_[j])) {
          ++j;
          continue;
        }
        segments_.erase(segments_.begin() + static_cast<std::ptrdiff_t>(j));
        j = i + 1;
      }
  }

  static bool joins(CylinderSegment& a, const CylinderSegment& b) {
    const CylinderFrame frame(a.cylinder);
    const CylinderFrame other(b.cylinder);
    const double first = frame.at(other.axis_at(b.lowest)).height;
    const double last = frame.at(other.axis_at(b.highest)).height;
    const double gap = std::max(std::min(first, last) - a.highest, a.lowest - std::max(first, last));
    if (gap > a.cylinder.radius) return false;
    if (!numeric::same_cylinder(a.cylinder, b.cylinder, other.axis_at((b.lowest + b.highest) / 2))) return false;
    a.lowest = std::min({a.lowest, first, last});
    a.highest = std::max({a.highest, first, last});
    return true;
  }

  // Each point goes to the nearest cylinder that it lies on.
  void label_points() {
    std::vector<double> nearest(points_.size(), settings_.criteria.distance);
    result_.labels.assign(points_.size(), -1);
    for (std::size_t n = 0; n < segments_.size(); ++n) {
      const CylinderSegment& segment = segments_[n];
      const CylinderFrame frame(segment.cylinder);
      for (std::size_t i = 0; i < points_.size(); ++i) {
        const auto [height, residual] = frame.at(points_[i]);
        if (std::abs(residual) > nearest[i] || height < segment.lowest || height > segment.highest) continue;
        nearest[i] = std::abs(residual);
        result_.labels[i] = static_cast<std::int32_t>(n);
      }
    }
  }

  void refine() {
    std::vector<std::vector<std::uint32_t>> members(segments_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (result_.labels[i] >= 0)
        members[static_cast<std::size_t>(result_.labels[i])].push_back(static_cast<std::uint32_t>(i));
    for (std::size_t n = 0; n < segments_.size(); ++n) {
      CylinderSegment& segment = segments_[n];
      segment.inliers = std::move(members[n]);
      std::vector<Point> all;
      for (const std::uint32_t i : segment.inliers) all.push_back(points_[i]);
      segment.cylinder = numeric::fit_cylinder(undisturbed(all, segment), segment.cylinder);
      measure(segment, all);
    }
  }

  // The last fit moves a cylinder, and its points with it. What has too few then, as happens in noise, is none.
  void choose_points() {
    for (bool all_stay = false; !all_stay;) {
      label_points();
      std::vector<std::size_t> distinct(segments_.size(), 0);
      for (CylinderSegment& segment : segments_) segment.inliers.clear();
      for (std::size_t i = 0; i < points_.size(); ++i) {
        if (result_.labels[i] < 0) continue;
        const auto n = static_cast<std::size_t>(result_.labels[i]);
        segments_[n].inliers.push_back(static_cast<std::uint32_t>(i));
        if (!is_copy_[i]) ++distinct[n];
      }
      const auto fewest = std::min_element(distinct.begin(), distinct.end());
      all_stay = distinct.empty() || *fewest >= settings_.criteria.min_inliers;
      if (!all_stay) segments_.erase(segments_.begin() + (fewest - distinct.begin()));
    }
    for (CylinderSegment& segment : segments_) {
      std::vector<Point> on;
      for (const std::uint32_t i : segment.inliers) on.push_back(points_[i]);
      segment.rms = numeric::rms_distance(on, segment.cylinder);
      measure(segment, on);
    }
  }

  // Points within the noise, away from the ends, where a pipe may begin to bend.
  static std::vector<Point> undisturbed(const std::vector<Point>& points, const CylinderSegment& segment) {
    const CylinderFrame frame(segment.cylinder);
    const double end = std::min(end_in_radii * segment.cylinder.radius, segment.length() * end_in_lengths);
    std::vector<Point> chosen;
    for (const Point& point : points) {
      const auto [height, residual] = frame.at(point);
      if (height >= segment.lowest + end && height <= segment.highest - end && std::abs(residual) <= segment.reach)
        chosen.push_back(point);
    }
    const std::size_t stride = chosen.size() / most_points_of_fit + 1;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < chosen.size(); i += stride) chosen[kept++] = chosen[i];
    chosen.resize(kept);
    return chosen;
  }

  static void measure(CylinderSegment& segment, const std::vector<Point>& points) {
    const CylinderFrame frame(segment.cylinder);
    if (points.empty()) return;
    segment.lowest = std::numeric_limits<double>::max();
    segment.highest = std::numeric_limits<double>::lowest();
    for (const Point& point : points) {
      const double height = frame.at(point).height;
      segment.lowest = std::min(segment.lowest, height);
      segment.highest = std::max(segment.highest, height);
    }
  }

  // In the order of the result, which the labels follow.
  void list_cylinders() {
    std::vector<std::int32_t> order(segments_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(i);
    const auto points_of = [&](std::int32_t i) { return segments_[static_cast<std::size_t>(i)].inliers.size(); };
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return points_of(a) > points_of(b); });
    std::vector<std::int32_t> rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      rank[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
      result_.cylinders.push_back(in_place(segments_[static_cast<std::size_t>(order[i])]));
      result_.counts.on_cylinders += result_.cylinders.back().inliers;
    }
    for (std::int32_t& label : result_.labels)
      if (label >= 0) label = rank[static_cast<std::size_t>(label)];
    result_.counts.cylinders = result_.cylinders.size();
  }

  ExtractedCylinder in_place(const CylinderSegment& segment) const {
    ExtractedCylinder cylinder{segment.cylinder.direction,      {},
                               segment.cylinder.radius * unit_, segment.length() * unit_,
                               segment.inliers.size(),          segment.rms * unit_};
    const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
    if (*std::max_element(cylinder.direction.begin(), cylinder.direction.end(), larger) < 0)
      for (double& component : cylinder.direction) component = -component;
    cylinder.axis_point = CylinderFrame(segment.cylinder).axis_at((segment.lowest + segment.highest) / 2);
    for (std::size_t k = 0; k < 3; ++k) cylinder.axis_point[k] = cylinder.axis_point[k] * unit_ + center_[k];
    return cylinder;
  }

  const CylinderExtractionProblem& problem_;
  const Options& options_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point stage_ = start_;
  Point center_{};
  // The search takes lengths in this unit, a power of two near the distance, so that no scale is special.
  double unit_ = 1;
  std::vector<Point> points_;
  // Of a point before it.
  std::vector<bool> is_copy_;
  // Without copies, in the order of their first ones.
  std::vector<Point> distinct_;
  CylinderSearchSettings settings_;
  std::vector<CylinderSegment> segments_;
  CylinderExtractionResult result_;
};

}  // namespace

CylinderExtractionResult extract_cylinders(const CylinderExtractionProblem& problem, const Options& options,
                                           const Context& context) {
  return Extraction(problem, options).run(context);
}

}  // namespace eliminant::intersect
