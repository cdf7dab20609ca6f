// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/result.hpp>

namespace eliminant::intersect {

/// A point cloud and what counts as a cylinder in it; lengths are in the unit of the points.
struct CylinderExtractionProblem {
  /// Finite, in any order.
  std::vector<std::array<double, 3>> points;
  /// Largest distance of a point from the cylinder it lies on: about three standard deviations of the noise.
  double distance = 0;
  /// Radii; unset: five times the distance, and 0.32 times the diagonal of the cloud's box without points far away.
  std::optional<double> min_radius;
  std::optional<double> max_radius;
  /// Fewest points of a cylinder; unset: 0.2 per cent of all, and 50 at least.
  std::optional<std::size_t> min_inliers;
  /// How likely it is at least that a cylinder with `min_inliers` points is found.
  double confidence = 0.99;
  /// The name of the cloud, for those who print the problem.
  std::string cloud;
  /// What the reader of the cloud had to say; repeated in the result.
  std::vector<std::string> warnings;
};

/// A piece of a circular cylinder and how well the points fit it.
struct ExtractedCylinder {
  /// Of length 1, its largest component positive.
  std::array<double, 3> direction{};
  /// The middle of its axis.
  std::array<double, 3> axis_point{};
  double radius = 0;
  double length = 0;
  /// Number of points labelled with it.
  std::size_t inliers = 0;
  /// Root of the mean squared distance of these points.
  double residual = 0;
};

struct CylinderExtractionCounts {
  std::size_t points = 0;
  std::size_t cylinders = 0;
  std::size_t on_cylinders = 0;
  /// Local samples of five points that were drawn.
  std::size_t samples = 0;
  /// Hypotheses that had the votes of one or more samples and were grown into the cloud.
  std::size_t candidates = 0;
};

struct CylinderExtractionResult {
  std::string problem = "cylinder_extraction";
  /// Never certified: points with noise prove nothing.
  Status status = Status::numeric;
  std::optional<std::string> limit;
  std::string cloud;
  CylinderExtractionCounts counts;
  /// By decreasing number of points.
  std::vector<ExtractedCylinder> cylinders;
  /// For every point the index of its cylinder, or -1.
  std::vector<std::int32_t> labels;
  /// What was looked for.
  double distance = 0;
  double min_radius = 0;
  double max_radius = 0;
  std::size_t min_inliers = 0;
  /// Of having found every cylinder with `min_inliers` points, estimated: see docs/cylinder-extraction.md.
  double confidence = 0;
  std::uint64_t seed = 0;
  std::vector<std::pair<std::string, double>> seconds;
  std::vector<std::string> warnings;
};

/// The circular cylinders in a point cloud: cylinders through five points of local samples vote, those with votes are
/// grown along their axes, fitted by least squares and judged; planes, spheres and tori are refused. The search ends
/// when a cylinder that is still missing is unlikely enough. The result follows from the problem and `options.seed`; it
/// does not depend on `options.threads`.
/// Guarantee: none, the status is `numeric` or, after a limit, `incomplete`. Throws InvalidInput for a distance or
/// radii that are not positive and finite, a confidence outside (0, 1), points that are not finite, and LimitReached
/// for more than 2^31 points. Source: the five-point problem of [DevillersMourrainPreparataTrebuchet2003] within the
/// sampling of [SchnabelWahlKlein2007]; docs/cylinder-extraction.md.
CylinderExtractionResult extract_cylinders(const CylinderExtractionProblem& problem, const Options& options,
                                           const Context& context);

}  // namespace eliminant::intersect
