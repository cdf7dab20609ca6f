// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/whole_surfaces/branch_tube.hpp>

namespace eliminant::intersect {

/// A known point of the intersection: the one point of an arc of its projection with u (or t) at a given value.
struct BranchSeed {
  /// Index of the arc.
  std::size_t arc = 0;
  /// 0: the value is that of u; 3: that of t, the arc being a part of a line u = constant.
  std::size_t axis = 0;
  /// The kept parameters, in the charts of the point: the one fixed, and the other one, isolated from those of all
  /// other points of the projection with that value.
  PointEnclosure point;
  DoubleInterval isolated;
  /// Whether the arc ends at infinity of space, backward (0) and forward (1) in the chart of the point.
  std::array<bool, 2> unbounded{};
};

/// A function of the parameters whose zeros are points without a place in affine space.
struct WeightFactor {
  /// Of which surface: parameters (0, 1) or (2, 3).
  std::size_t first_parameter = 0;
  /// Coefficients of a polynomial of the degrees, in affine parameters, as SurfaceCharts has them.
  std::array<std::size_t, 2> degree{};
  std::vector<DoubleInterval> coefficients;

  struct Jet {
    DoubleInterval value;
    std::array<DoubleInterval, 2> derivative;
  };
  Jet jet(const Charts& inverted, const ParameterBox& box) const;
};

/// One proven piece of a traced branch.
struct BranchSegment {
  BranchTube tube;
  /// Both ends, in the charts of the tube.
  PointEnclosure start;
  PointEnclosure end;
  /// Zeros of the weight inside: the branch goes to infinity and comes back.
  bool crosses_infinity = false;
  /// Bounds the distance in space between the chord and the branch; infinite where the weight may be zero.
  double error = 0;
};

/// A passage through a seed.
struct SeedPassage {
  std::size_t seed = 0;
  std::size_t segment = 0;
  /// In the direction of increasing value of the seed's axis.
  bool forward = true;
};

struct TracedBranch {
  std::vector<BranchSegment> segments;
  std::vector<SeedPassage> passages;
  /// It came back to its origin; otherwise the tube test failed for the least step, or a limit was reached.
  bool closed = false;
};

struct TracingLimits {
  double first_step = 0.02;
  double least_step = 1e-7;
  double largest_step = 0.1;
  /// Largest distance of a chord from the branch, relative to max(size, |point|), where it can be had without short
  /// steps.
  double tolerance = 1e-3;
  double size = 1;
  /// Beyond this distance, compared with the size or the seed's, branches above unbounded arcs are left; all of them
  /// beyond a modulus of their parameters.
  double reach = std::numeric_limits<double>::infinity();
  double largest_parameter = 1e3;
  std::size_t most_segments = 20000;
};

/// Follows smooth branches by overlapping tubes, without ever passing from one to another.
class TubeTracer {
 public:
  /// All must outlive the object.
  TubeTracer(const SurfacePair& pair, const std::vector<BranchSeed>& seeds, const std::vector<WeightFactor>& weights,
             const TracingLimits& limits, const Context& context)
      : pair_(pair), seeds_(seeds), weights_(weights), limits_(limits), context_(context) {}

  /// From a seed, to increasing or decreasing values of its axis in its chart, until the branch is back at the seed
  /// `origin`, or the tubes end.
  TracedBranch trace(std::size_t seed, bool forward, std::size_t origin) const;

 private:
  enum class Passage { none, passes, undecided };
  struct Crossing {
    Passage passage = Passage::none;
    bool forward = true;
  };

  Crossing crossing(const BranchSegment& segment, const BranchSeed& seed) const;
  /// 0 or 1 zeros of the weight factors on the segment; nullopt when that is not clear.
  std::optional<bool> crosses_infinity(const BranchSegment& segment) const;
  std::optional<BranchSegment> advance(const PointEnclosure& from, const std::array<double, 4>& direction,
                                       double step) const;

  const SurfacePair& pair_;
  const std::vector<BranchSeed>& seeds_;
  const std::vector<WeightFactor>& weights_;
  const TracingLimits& limits_;
  const Context& context_;
};

/// The factors of the weights of both surfaces, each squarefree, those at infinite parameters among them.
std::vector<WeightFactor> weight_factors(const symbolic::RationalSurface& first,
                                         const symbolic::RationalSurface& second, std::uint64_t seed);

}  // namespace eliminant::intersect
