// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/cylinder_growth.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace eliminant::numeric {

namespace {

struct Inlier {
  std::uint32_t index;
  double height;
};

// Points within `reach` of the cylinder, between two heights.
std::vector<Inlier> inliers_between(std::span<const Point> points, const CylinderFrame& frame, double lowest,
                                    double highest, double reach) {
  std::vector<Inlier> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [height, residual] = frame.at(points[i]);
    if (height >= lowest && height <= highest && std::abs(residual) <= reach)
      found.push_back({static_cast<std::uint32_t>(i), height});
  }
  return found;
}

// Heights cut into bins of equal width.
class HeightBins {
 public:
  HeightBins(const std::vector<Inlier>& inliers, double lowest, double highest, double width)
      : lowest_(lowest), width_(width) {
    counts_.assign(static_cast<std::size_t>((highest - lowest) / width) + 1, 0);
    for (const Inlier& inlier : inliers) ++counts_[bin_of(inlier.height)];
  }

  std::size_t bin_of(double height) const {
    const double bin = std::clamp((height - lowest_) / width_, 0.0, static_cast<double>(counts_.size() - 1));
    return static_cast<std::size_t>(bin);
  }

  // First and last bin of those reached from the bin `home` over gaps of at most `gap` bins; a bin with fewer points
  // than `least` is a gap.
  std::pair<std::size_t, std::size_t> run_around(std::size_t home, double least, std::size_t gap) const {
    std::size_t first = home;
    for (std::size_t at = home; at > 0 && first - (at - 1) <= gap + 1;)
      if (filled(--at, least)) first = at;
    std::size_t last = home;
    for (std::size_t at = home + 1; at < counts_.size() && at - last <= gap + 1; ++at)
      if (filled(at, least)) last = at;
    return {first, last};
  }

  double median_of(std::size_t first, std::size_t last) const {
    std::vector<std::size_t> run(counts_.begin() + static_cast<std::ptrdiff_t>(first),
                                 counts_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const auto middle = run.begin() + static_cast<std::ptrdiff_t>(run.size() / 2);
    std::nth_element(run.begin(), middle, run.end());
    return static_cast<double>(*middle);
  }

 private:
  bool filled(std::size_t bin, double least) const { return static_cast<double>(counts_[bin]) >= least; }

  double lowest_;
  double width_;
  std::vector<std::size_t> counts_;
};

constexpr std::size_t most_rounds = 30;
// Of a bin with a usual number of points, so that gaps are seen where the scan is dense.
constexpr double least_filling = 0.2;
constexpr double least_bin_points = 6;
constexpr double longest_gap_in_radii = 1;
// What a fit while growing needs; the last one has all points.
constexpr std::size_t points_while_growing = 1500;
constexpr std::size_t points_at_the_end = 20000;

Cylinder fit_some(std::span<const Point> points, const std::vector<Inlier>& inliers, std::size_t most,
                  const Cylinder& start) {
  const std::size_t stride = inliers.size() / most + 1;
  std::vector<Point> chosen;
  for (std::size_t i = 0; i < inliers.size(); i += stride) chosen.push_back(points[inliers[i].index]);
  return fit_cylinder(chosen, start);
}

// Grows one segment.
class Growth {
 public:
  Growth(std::span<const Point> points, const Cylinder& start, const Point& seed, double half_length,
         const CylinderCriteria& criteria)
      : points_(points), seed_(seed), criteria_(criteria), cylinder_(start) {
    const double height = CylinderFrame(start).at(seed).height;
    lowest_ = height - half_length;
    highest_ = height + half_length;
  }

  CylinderSegment grow() {
    bool growing = true;
    for (std::size_t round = 0; round < most_rounds && growing; ++round) {
      const double before = highest_ - lowest_;
      // A look beyond both ends: a cylinder that is not yet exact is trusted as far again as it has been seen.
      const double beyond = round == 0 ? 0 : before / 2;
      find_run(lowest_ - beyond, highest_ + beyond, round == 0 ? 2 : 1);
      if (run_.size() < 5) break;
      refit(points_while_growing);
      growing = round == 0 || highest_ - lowest_ > 1.02 * before;
    }
    for (int i = 0; i < 2 && run_.size() >= 5; ++i) {
      refit(points_at_the_end);
      find_run(lowest_ - cylinder_.radius, highest_ + cylinder_.radius, 1);
    }
    return segment();
  }

 private:
  void find_run(double lowest, double highest, double slack) {
    const CylinderFrame frame(cylinder_);
    const std::vector<Inlier> near = inliers_between(points_, frame, lowest, highest, slack * criteria_.distance);
    run_.clear();
    if (near.empty()) return;
    const double density = static_cast<double>(near.size()) / (highest - lowest);
    const double width = std::max(cylinder_.radius / 4, least_bin_points / density);
    const HeightBins bins(near, lowest, highest, width);
    const std::size_t home = bins.bin_of(frame.at(seed_).height);
    const auto gap = static_cast<std::size_t>(longest_gap_in_radii * cylinder_.radius / width);
    auto [first, last] = bins.run_around(home, 1, gap);
    const double usual = bins.median_of(first, last);
    std::tie(first, last) = bins.run_around(home, std::max(1.0, least_filling * usual), gap);
    lowest_ = highest;
    highest_ = lowest;
    for (const Inlier& inlier : near) {
      const std::size_t bin = bins.bin_of(inlier.height);
      if (bin < first || bin > last) continue;
      run_.push_back(inlier);
      lowest_ = std::min(lowest_, inlier.height);
      highest_ = std::max(highest_, inlier.height);
    }
  }

  // Fits to the run; heights are told anew because the axis point moves.
  void refit(std::size_t most) {
    const CylinderFrame before(cylinder_);
    const Point low = before.axis_at(lowest_);
    const Point high = before.axis_at(highest_);
    cylinder_ = fit_some(points_, run_, most, cylinder_);
    const CylinderFrame after(cylinder_);
    lowest_ = after.at(low).height;
    highest_ = after.at(high).height;
    if (lowest_ > highest_) std::swap(lowest_, highest_);
  }

  CylinderSegment segment() const {
    CylinderSegment segment{cylinder_, lowest_, highest_, {}, 0};
    std::vector<Point> on;
    for (const Inlier& inlier : run_) {
      segment.inliers.push_back(inlier.index);
      on.push_back(points_[inlier.index]);
    }
    segment.rms = rms_distance(on, cylinder_);
    return segment;
  }

  std::span<const Point> points_;
  Point seed_;
  const CylinderCriteria& criteria_;
  Cylinder cylinder_;
  double lowest_ = 0;
  double highest_ = 0;
  std::vector<Inlier> run_;
};

constexpr std::size_t sectors = 32;
constexpr double least_covered = 0.25;
// A surface that leaves the layer |residual| <= d on both sides fills the layers up to 3 d with sqrt(3) - 1 = 0.73 as
// many points; noise of which d is one standard deviation with 0.46.
constexpr double most_beside = 0.6;
constexpr double largest_bend = 0.5;  // of the distance, at the ends

bool is_covered(std::span<const Point> points, const CylinderSegment& segment) {
  const CylinderFrame frame(segment.cylinder);
  std::array<std::size_t, sectors> counts{};
  for (const std::uint32_t i : segment.inliers) {
    const double turn = (frame.angle(points[i]) / std::numbers::pi + 1) / 2;
    ++counts[std::min(sectors - 1, static_cast<std::size_t>(turn * sectors))];
  }
  const double usual = static_cast<double>(segment.inliers.size()) / sectors;
  const auto covered =
      std::count_if(counts.begin(), counts.end(), [&](std::size_t n) { return static_cast<double>(n) >= usual / 4; });
  return static_cast<double>(covered) >= least_covered * sectors;
}

// The residuals as a combination of 1, h, h^2, h^2 cos, h^2 sin, h from -1 to 1 along the segment: on a cone the second
// shows, on a sphere the third, on a torus the last two.
bool is_straight(std::span<const Point> points, const CylinderSegment& segment, double distance) {
  const CylinderFrame frame(segment.cylinder);
  const double middle = (segment.lowest + segment.highest) / 2;
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
  for (const std::uint32_t i : segment.inliers) {
    const auto [height, residual] = frame.at(points[i]);
    const double h = 2 * (height - middle) / segment.length();
    const double angle = frame.angle(points[i]);
    const Eigen::Matrix<double, 5, 1> row(1, h, h * h, h * h * std::cos(angle), h * h * std::sin(angle));
    normal += row * row.transpose();
    right += residual * row;
  }
  const Eigen::Matrix<double, 5, 1> shape = normal.ldlt().solve(right);
  return std::max({std::abs(shape[1]), std::abs(shape[2]), std::hypot(shape[3], shape[4])}) <= largest_bend * distance;
}

bool ends_at_its_sides(std::span<const Point> points, const CylinderSegment& segment, double distance) {
  const CylinderFrame frame(segment.cylinder);
  const std::size_t near = inliers_between(points, frame, segment.lowest, segment.highest, 3 * distance).size();
  return static_cast<double>(near - segment.inliers.size()) <= most_beside * static_cast<double>(segment.inliers.size());
}

}  // namespace

CylinderSegment grow_cylinder(std::span<const Point> points, const Cylinder& start, const Point& seed,
                              double half_length, const CylinderCriteria& criteria) {
  return Growth(points, start, seed, half_length, criteria).grow();
}

SegmentVerdict judge_segment(std::span<const Point> points, const CylinderSegment& segment,
                             const CylinderCriteria& criteria) {
  const double radius = segment.cylinder.radius;
  if (segment.inliers.size() < criteria.min_inliers) return SegmentVerdict::few_points;
  if (radius < criteria.min_radius || radius > criteria.max_radius) return SegmentVerdict::radius;
  if (segment.length() < radius) return SegmentVerdict::short_;
  if (!is_covered(points, segment)) return SegmentVerdict::narrow;
  if (!is_straight(points, segment, criteria.distance)) return SegmentVerdict::curved;
  if (!ends_at_its_sides(points, segment, criteria.distance)) return SegmentVerdict::beside;
  return SegmentVerdict::cylinder;
}

}  // namespace eliminant::numeric
