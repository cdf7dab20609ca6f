// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/cylinder_growth.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <eliminant/numeric/cylinder_layer.hpp>

namespace eliminant::numeric {

namespace {

// Heights cut into bins of equal width.
class HeightBins {
 public:
  HeightBins(const std::vector<NearPoint>& points, double lowest, double highest, double width)
      : lowest_(lowest), width_(width) {
    counts_.assign(static_cast<std::size_t>((highest - lowest) / width) + 1, 0);
    beside_ = counts_;
    for (const NearPoint& point : points) ++(point.on ? counts_ : beside_)[bin_of(point.height)];
  }

  std::size_t bin_of(double height) const {
    const double bin = std::clamp((height - lowest_) / width_, 0.0, static_cast<double>(counts_.size() - 1));
    return static_cast<std::size_t>(bin);
  }

  // First and last bin of those reached from the bin `home` over gaps of at most `gap` bins; a bin is a gap when it has
  // fewer points than `least`, or when the surface leaves the cylinder there, as where a pipe bends.
  std::pair<std::size_t, std::size_t> run_around(std::size_t home, double least, std::size_t gap) const {
    std::size_t first = home;
    for (std::size_t at = home; at > 0 && first - (at - 1) <= gap + 1;)
      if (filled(--at, least)) first = at;
    std::size_t last = home;
    for (std::size_t at = home + 1; at < counts_.size() && at - last <= gap + 1; ++at)
      if (filled(at, least)) last = at;
    return {first, last};
  }

  // The number of points in a bin, seen by the points between two bins: empty ends do not change it much.
  double usual_between(std::size_t first, std::size_t last) const {
    return usual_count({counts_.data() + first, last - first + 1});
  }

 private:
  bool filled(std::size_t bin, double least) const {
    return static_cast<double>(counts_[bin]) >= least && ends_in_layer(counts_[bin], beside_[bin]);
  }

  double lowest_;
  double width_;
  std::vector<std::size_t> counts_;
  std::vector<std::size_t> beside_;
};

constexpr std::size_t most_rounds = 30;
// Of a bin with the usual number of points: less is chance, or another surface that only touches.
constexpr double least_filling = 0.15;
constexpr double least_bin_points = 6;
constexpr double longest_gap_in_radii = 1;
// Of the distances of normal noise, in standard deviations.
constexpr double median_of_normal = 0.6745;
constexpr double deviations_of_reach = 3.5;
constexpr std::size_t least_points_of_noise = 20;
// What a fit while growing needs; the last one has all points.
constexpr std::size_t points_while_growing = 1500;
constexpr std::size_t points_at_the_end = 20000;

Cylinder fit_some(std::span<const Point> points, const std::vector<NearPoint>& inliers, std::size_t most,
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
      : points_(points), seed_(seed), distance_(criteria.distance), reach_(criteria.distance), cylinder_(start) {
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
      narrow_reach();
      refit(points_at_the_end);
      find_run(lowest_ - cylinder_.radius, highest_ + cylinder_.radius, 1);
    }
    return segment();
  }

 private:
  void find_run(double lowest, double highest, double slack) {
    const CylinderFrame frame(cylinder_);
    const std::vector<NearPoint> near = points_near(points_, frame, lowest, highest, slack * reach_);
    run_.clear();
    const auto on = std::count_if(near.begin(), near.end(), [](const NearPoint& point) { return point.on; });
    if (on == 0) return;
    const double density = static_cast<double>(on) / (highest - lowest);
    const double width = std::max(cylinder_.radius / 4, least_bin_points / density);
    const HeightBins bins(near, lowest, highest, width);
    const std::size_t home = bins.bin_of(frame.at(seed_).height);
    const auto gap = static_cast<std::size_t>(longest_gap_in_radii * cylinder_.radius / width);
    auto [first, last] = bins.run_around(home, 1, gap);
    const double usual = bins.usual_between(first, last);
    std::tie(first, last) = bins.run_around(home, std::max(1.0, least_filling * usual), gap);
    lowest_ = highest;
    highest_ = lowest;
    for (const NearPoint& point : near) {
      const std::size_t bin = bins.bin_of(point.height);
      if (!point.on || bin < first || bin > last) continue;
      run_.push_back(point);
      lowest_ = std::min(lowest_, point.height);
      highest_ = std::max(highest_, point.height);
    }
  }

  // The noise by the median of the residuals in the middle half of the run, where no other surface touches.
  void narrow_reach() {
    const CylinderFrame frame(cylinder_);
    std::vector<double> residuals;
    for (const NearPoint& point : run_)
      if (std::abs(point.height - (lowest_ + highest_) / 2) <= (highest_ - lowest_) / 4)
        residuals.push_back(std::abs(frame.at(points_[point.index]).residual));
    if (residuals.size() < least_points_of_noise) return;
    const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
    std::nth_element(residuals.begin(), middle, residuals.end());
    const double deviation = *middle / median_of_normal;
    reach_ = std::clamp(deviations_of_reach * deviation, distance_ / 10, distance_);
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
    CylinderSegment segment{cylinder_, lowest_, highest_, reach_, {}, 0};
    std::vector<Point> on;
    for (const NearPoint& point : run_) {
      segment.inliers.push_back(point.index);
      on.push_back(points_[point.index]);
    }
    segment.rms = rms_distance(on, cylinder_);
    return segment;
  }

  std::span<const Point> points_;
  Point seed_;
  double distance_;
  double reach_;
  Cylinder cylinder_;
  double lowest_ = 0;
  double highest_ = 0;
  std::vector<NearPoint> run_;
};

}  // namespace

CylinderSegment grow_cylinder(std::span<const Point> points, const Cylinder& start, const Point& seed,
                              double half_length, const CylinderCriteria& criteria) {
  return Growth(points, start, seed, half_length, criteria).grow();
}

}  // namespace eliminant::numeric
