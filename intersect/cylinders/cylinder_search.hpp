// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/numeric/cylinder_growth.hpp>
#include <eliminant/numeric/cylinder_votes.hpp>

namespace eliminant::intersect {

/// How a cloud is searched for cylinders.
struct CylinderSearchSettings {
  numeric::CylinderCriteria criteria;
  double confidence = 0.99;
  std::uint64_t seed = 0;
  unsigned threads = 1;
};

/// The search for the cylinders of a cloud, round by round: local samples, votes, growth, and the points of what was
/// found are taken away.
class CylinderSearch {
 public:
  /// The points must outlive the search. They should be around the origin.
  CylinderSearch(std::span<const numeric::Point> points, const CylinderSearchSettings& settings);

  /// Searches until the confidence is reached. After an exception (LimitReached of `context`) what was found is there.
  void run(const Context& context);

  /// In the order of their discovery; indices of inliers are those of the points given.
  const std::vector<numeric::CylinderSegment>& found() const { return found_; }
  /// Estimated probability that a cylinder with the fewest inliers asked for would have been found.
  double confidence() const;
  std::size_t samples() const { return samples_; }
  std::size_t candidates() const { return candidates_; }

 private:
  struct Round {
    std::vector<std::size_t> seeds;
    std::vector<numeric::CylinderHypothesis> hypotheses;
  };

  void build_grids();
  Round draw_samples();
  std::vector<numeric::CylinderSegment> grow(const std::vector<numeric::CylinderVotes>& votes);
  bool accept(std::vector<numeric::CylinderSegment> segments, const Round& round);
  void learn_rate(const numeric::CylinderSegment& segment, const Round& round);
  void remove_found();

  std::span<const numeric::Point> points_;
  CylinderSearchSettings settings_;
  std::vector<double> scales_;
  /// The points that belong to nothing yet, and which of all they are.
  std::vector<numeric::Point> left_;
  std::vector<std::uint32_t> left_index_;
  std::vector<numeric::PointGrid> grids_;
  std::vector<numeric::CylinderSegment> found_;
  std::size_t rounds_ = 0;
  std::size_t samples_ = 0;
  std::size_t candidates_ = 0;
  /// Expected number of samples so far whose seed lies on a given cylinder with the fewest inliers asked for.
  double expected_seeds_ = 0;
  /// Probability that such a sample shows the cylinder.
  double success_rate_ = 0;
};

}  // namespace eliminant::intersect
