// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/cylinders/cylinder_search.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include <eliminant/base/parallel_tasks.hpp>
#include <eliminant/numeric/cylinder_judgement.hpp>

namespace eliminant::intersect {

namespace {

using numeric::CylinderFrame;
using numeric::CylinderHypothesis;
using numeric::CylinderSegment;
using numeric::CylinderVotes;
using numeric::Point;
using numeric::SplitMix64;

constexpr std::size_t samples_in_round = 4096;
constexpr std::size_t samples_in_task = 64;
// Of a sample that begins on a cylinder, in a ball as large as the cylinder asks for: each of four more points lies on
// it with probability 1/2 at least, and noise leaves every second such sample useful.
constexpr double success_in_right_ball = 1.0 / 32;
// Part of a segment's points that may belong to one that was found before in the same round.
constexpr double largest_overlap = 0.1;
// Noise has tails: points taken away with a cylinder, in units of the distance.
constexpr double removal_reach = 2;

}  // namespace

CylinderSearch::CylinderSearch(std::span<const Point> points, const CylinderSearchSettings& settings)
    : points_(points), settings_(settings), left_(points.begin(), points.end()), left_index_(points.size()) {
  std::iota(left_index_.begin(), left_index_.end(), 0U);
  const numeric::CylinderCriteria& criteria = settings.criteria;
  for (double scale = criteria.min_radius; scales_.empty() || scale < 2 * criteria.max_radius; scale *= 2)
    scales_.push_back(scale);
  success_rate_ = success_in_right_ball / static_cast<double>(scales_.size());
}

double CylinderSearch::confidence() const { return -std::expm1(-expected_seeds_ * success_rate_); }

void CylinderSearch::run(const Context& context) {
  const std::size_t fewest = std::max<std::size_t>(settings_.criteria.min_inliers, 5);
  bool changed = true;
  while (left_.size() >= fewest && confidence() < settings_.confidence) {
    context.checkpoint("search, " + std::to_string(samples_) + " samples, " + std::to_string(found_.size()) +
                       " cylinders");
    if (changed) build_grids();
    const Round round = draw_samples();
    expected_seeds_ +=
        static_cast<double>(samples_in_round) * static_cast<double>(fewest) / static_cast<double>(left_.size());
    changed = accept(grow(numeric::gather_votes(round.hypotheses, left_)), round);
  }
  if (left_.size() < fewest) expected_seeds_ = HUGE_VAL;
}

void CylinderSearch::build_grids() {
  std::vector<std::optional<numeric::PointGrid>> built(scales_.size());
  parallel_tasks(scales_.size(), settings_.threads, [&](std::size_t i) { built[i].emplace(left_, scales_[i]); });
  grids_.clear();
  for (auto& grid : built) grids_.push_back(std::move(*grid));
}

CylinderSearch::Round CylinderSearch::draw_samples() {
  Round round;
  round.seeds.resize(samples_in_round);
  std::vector<std::optional<CylinderHypothesis>> drawn(samples_in_round);
  const std::uint64_t stream = SplitMix64(settings_.seed + rounds_).next();
  parallel_tasks(samples_in_round / samples_in_task, settings_.threads, [&](std::size_t task) {
    for (std::size_t i = task * samples_in_task; i < (task + 1) * samples_in_task; ++i) {
      SplitMix64 random(stream + i);
      round.seeds[i] = random.below(left_.size());
      drawn[i] = numeric::sample_cylinder(left_, grids_[i % grids_.size()], round.seeds[i], settings_.criteria, random);
    }
  });
  for (const auto& hypothesis : drawn)
    if (hypothesis) round.hypotheses.push_back(*hypothesis);
  ++rounds_;
  samples_ += samples_in_round;
  return round;
}

std::vector<CylinderSegment> CylinderSearch::grow(const std::vector<CylinderVotes>& votes) {
  std::vector<std::optional<CylinderSegment>> grown(votes.size());
  parallel_tasks(votes.size(), settings_.threads, [&](std::size_t i) {
    const CylinderHypothesis& best = votes[i].best;
    CylinderSegment segment =
        numeric::grow_cylinder(left_, best.cylinder, left_[best.seed], best.ball_radius, settings_.criteria);
    if (numeric::judge_segment(left_, points_, segment, settings_.criteria) == numeric::SegmentVerdict::cylinder)
      grown[i] = std::move(segment);
  });
  candidates_ += votes.size();
  std::vector<CylinderSegment> segments;
  for (auto& segment : grown)
    if (segment) segments.push_back(std::move(*segment));
  std::stable_sort(segments.begin(), segments.end(), [](const CylinderSegment& a, const CylinderSegment& b) {
    return a.inliers.size() > b.inliers.size();
  });
  return segments;
}

bool CylinderSearch::accept(std::vector<CylinderSegment> segments, const Round& round) {
  std::vector<bool> taken(left_.size(), false);
  const std::size_t before = found_.size();
  for (CylinderSegment& segment : segments) {
    const auto shared = std::count_if(segment.inliers.begin(), segment.inliers.end(), [&](auto i) { return taken[i]; });
    if (static_cast<double>(shared) > largest_overlap * static_cast<double>(segment.inliers.size())) continue;
    learn_rate(segment, round);
    const CylinderFrame frame(segment.cylinder);
    const double reach = removal_reach * settings_.criteria.distance;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const auto [height, residual] = frame.at(left_[i]);
      if (std::abs(residual) <= reach && height >= segment.lowest - reach && height <= segment.highest + reach)
        taken[i] = true;
    }
    for (std::uint32_t& i : segment.inliers) i = left_index_[i];
    found_.push_back(std::move(segment));
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < left_.size(); ++i) {
    if (taken[i]) continue;
    left_[kept] = left_[i];
    left_index_[kept++] = left_index_[i];
  }
  left_.resize(kept);
  left_index_.resize(kept);
  return found_.size() > before;
}

// A cylinder that showed in fewer of its samples than expected makes the search more careful.
void CylinderSearch::learn_rate(const CylinderSegment& segment, const Round& round) {
  const auto on = [&](std::size_t point) {
    return std::binary_search(segment.inliers.begin(), segment.inliers.end(), static_cast<std::uint32_t>(point));
  };
  const auto trials = std::count_if(round.seeds.begin(), round.seeds.end(), on);
  const auto successes =
      std::count_if(round.hypotheses.begin(), round.hypotheses.end(), [&](const CylinderHypothesis& hypothesis) {
        return on(hypothesis.seed) &&
               numeric::same_cylinder(segment.cylinder, hypothesis.cylinder, left_[hypothesis.seed]);
      });
  success_rate_ = std::min(success_rate_, static_cast<double>(successes + 1) / static_cast<double>(trials + 1));
}

}  // namespace eliminant::intersect
