// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <eliminant/bridge/nets/columns.hpp>
#include <eliminant/bridge/nets/net_side.hpp>

namespace eliminant::bridge {

/// What was learnt of a pair of parts, in local coordinates: [-1, 1] for every parameter.
template <std::size_t N>
struct Verdict {
  bool excluded = false;
  /// All zeros of the pair have local coordinates in [lower, upper].
  Array4d lower = Array4d::Constant(-1);
  Array4d upper = Array4d::Constant(1);
  /// One zero exactly, and x - C F(x) contracts by `contraction` in the maximum norm.
  bool one_zero = false;
  double contraction = infinity;
  Columns preconditioner;
  /// The Jacobian matrix is nearly singular somewhere near.
  bool nearly_parallel = false;
  /// Where to cut when nothing else helps.
  std::size_t axis = 0;
};

/// Looks at pairs of parts of two nets.
template <std::size_t PA, std::size_t PB>
class PairTest {
 public:
  static constexpr std::size_t N = PA + PB;

  /// Their parts are put into them one pair after the other, and bounded.
  Side<PA> first;
  Side<PB> second;

  bool apart() const {
    for (long k = 0; k < static_cast<long>(N); ++k)
      if (first.box.upper[k] < second.box.lower[k] || second.box.upper[k] < first.box.lower[k]) return true;
    return false;
  }

  /// What the preconditioned control points say. `widest` is the largest width of the parts in their parameters.
  Verdict<N> examine(double widest) {
    Verdict<N> verdict;
    const auto [jacobian, volume] = secants();
    auto [inverse, determinant] = adjugate<N>(jacobian);
    constexpr double parallel = 0.1;
    verdict.nearly_parallel = !(std::fabs(determinant) > parallel * volume);
    // Small parts are so near to flat that even nearly parallel ones have an inverse that helps.
    const double well_conditioned = std::min(1e-3, 0.5 * widest);
    if (!(std::fabs(determinant) > well_conditioned * volume)) {
      // Rows of the adjugate are still normals of one side, or of both.
      verdict.excluded = separated(inverse);
      verdict.axis = widest_axis();
      return verdict;
    }
    for (Array4d& column : inverse) column /= determinant;
    verdict.preconditioner = inverse;
    verdict.excluded = is_rational() && separated(inverse);
    if (!verdict.excluded) bound_zeros(verdict);
    return verdict;
  }

 private:
  /// The preconditioned control points of one side, minus (first side) or plus (second side) those of the local
  /// coordinates that belong to it: their bounds, those of the derivatives, and how weights that vary spread them.
  template <std::size_t P>
  struct Preconditioned {
    Bounds values;
    /// Before the local coordinates were taken off; only of a rational pair, of both sides.
    Array4d magnitude = Array4d::Zero();
    std::array<Array4d, P> slopes;
    std::array<double, P> weight_slopes{};
  };

  bool is_rational() const { return !first.polynomial || !second.polynomial; }

  /// The derivatives of the difference by the local parameters from one end to the other, and the product of their
  /// lengths.
  std::pair<Columns, double> secants() const {
    Columns jacobian{Array4d::Zero(), Array4d::Zero(), Array4d::Zero()};
    double volume = 1;
    for (std::size_t k = 0; k < N; ++k) {
      jacobian[k] = k < PA ? secant(first, k) : Array4d(-secant(second, k - PA));
      jacobian[k][3] = 0;
      if (N == 2) jacobian[k][2] = 0;
      volume *= std::sqrt(jacobian[k].square().sum());
    }
    return {jacobian, volume};
  }

  /// Where zeros can be, and whether there is exactly one.
  void bound_zeros(Verdict<N>& verdict) {
    const Columns& c = verdict.preconditioner;
    const bool rational = is_rational();
    const Array4d shift = rational ? middle() : Array4d::Zero();
    const Preconditioned<PA> a = precondition(first, c, shift, 1, 0);
    const Preconditioned<PB> b = precondition(second, c, shift, -1, PA);

    // What rounding and the errors of the control points add, in units of the local coordinates.
    const Array4d size = moved_size(first, shift) + moved_size(second, shift);
    const Array4d error =
        times(absolute(c), moved_error(first, shift) + moved_error(second, shift) + 16 * unit_roundoff * size) +
        16 * unit_roundoff;
    Array4d remainder = Array4d::Zero();
    if (rational) {
      const Array4d largest_a = a.magnitude + error;
      const Array4d largest_b = b.magnitude + error;
      remainder = (largest_a * second.weight_spread + largest_b * first.weight_spread) * (1 + 1e-12);
    }
    // Local coordinates = -(preconditioned difference - local coordinates).
    const Array4d lower = b.values.lower - a.values.upper - error - remainder;
    const Array4d upper = b.values.upper - a.values.lower + error + remainder;

    Array4d row_sums = Array4d::Zero();
    Array4d column_sizes = Array4d::Zero();
    const auto add = [&](const Array4d& slope, std::size_t k) {
      row_sums += slope;
      column_sizes[static_cast<long>(k)] = slope.head<static_cast<int>(N)>().maxCoeff();
    };
    const auto slope_of = [&](const auto& side, const auto& other, const auto& part, const auto& other_part,
                              std::size_t axis, std::size_t k) {
      Array4d slope = part.slopes[axis] + static_cast<double>(side.shape.degree[axis]) * error;
      if (rational) {
        Array4d whole = slope;
        whole[static_cast<long>(k)] += 1;
        slope +=
            (whole * other.weight_spread + (other_part.magnitude + error) * part.weight_slopes[axis]) * (1 + 1e-12);
      }
      add(slope * (1 + 1e-12), k);
    };
    for (std::size_t axis = 0; axis < PA; ++axis) slope_of(first, second, a, b, axis, axis);
    for (std::size_t axis = 0; axis < PB; ++axis) slope_of(second, first, b, a, axis, PA + axis);

    bool into_itself = true;
    for (std::size_t k = 0; k < N; ++k) {
      const long i = static_cast<long>(k);
      if (!(lower[i] <= 1) || !(upper[i] >= -1)) {
        verdict.excluded = std::isfinite(lower[i]) && std::isfinite(upper[i]);
        if (verdict.excluded) return;
      }
      into_itself = into_itself && lower[i] > -1 && upper[i] < 1;
      verdict.lower[i] = std::max(lower[i], -1.0);
      verdict.upper[i] = std::min(upper[i], 1.0);
    }
    verdict.contraction = row_sums.head<static_cast<int>(N)>().maxCoeff();
    constexpr double at_most = 0.95;
    verdict.one_zero = into_itself && verdict.contraction < at_most;
    column_sizes.head<static_cast<int>(N)>().maxCoeff(&verdict.axis);
  }

  template <std::size_t P>
  Preconditioned<P> precondition(const Side<P>& side, const Columns& c, const Array4d& shift, double sign,
                                 std::size_t first_axis) {
    Preconditioned<P> result;
    const bool rational = is_rational();
    const std::size_t count = side.shape.size();
    scratch_.resize(std::max(scratch_.size(), count));
    const double inverse_weight = 1 / side.weight;
    Bounds plain;
    for (std::size_t i = 0; i < count; ++i) {
      const Array4d moved = side.polynomial ? Array4d(side.points[i] - shift)
                                            : Array4d((side.points[i] - shift * side.points[i][3]) * inverse_weight);
      scratch_[i] = times(c, moved);
      if (rational) plain.take(scratch_[i]);
    }
    if (rational) result.magnitude = plain.magnitude();
    for (std::size_t axis = 0; axis < P; ++axis) {
      const long lane = static_cast<long>(first_axis + axis);
      const double step = sign * 2 / static_cast<double>(side.shape.degree[axis]);
      const std::size_t stride = side.shape.stride(axis);
      side.shape.for_each_line(axis, [&](std::size_t base) {
        for (std::size_t i = 0; i <= side.shape.degree[axis]; ++i)
          scratch_[base + i * stride][lane] -= static_cast<double>(i) * step - sign;
      });
    }
    for (std::size_t i = 0; i < count; ++i) result.values.take(scratch_[i]);
    for (std::size_t axis = 0; axis < P; ++axis) {
      const std::size_t stride = side.shape.stride(axis);
      Array4d largest = Array4d::Zero();
      double weights = 0;
      side.shape.for_each_line(axis, [&](std::size_t base) {
        for (std::size_t i = 0; i < side.shape.degree[axis]; ++i) {
          const std::size_t at = base + i * stride;
          largest = largest.max((scratch_[at + stride] - scratch_[at]).abs());
          if (!side.polynomial)
            weights = std::max(weights, std::fabs(side.points[at + stride][3] - side.points[at][3]));
        }
      });
      const double half_degree = 0.5 * static_cast<double>(side.shape.degree[axis]);
      result.slopes[axis] = half_degree * largest;
      result.weight_slopes[axis] = half_degree * (weights + 4 * side.error[3]) * inverse_weight * (1 + 1e-12);
    }
    return result;
  }

  /// Where along a row of the preconditioner both sides are apart, weights divided out.
  bool separated(const Columns& c) {
    const auto bounds = [&](const auto& side) {
      Bounds result;
      for (std::size_t i = 0; i < side.shape.size(); ++i)
        result.take(times(c, side.polynomial ? side.points[i] : Array4d(side.points[i] / side.points[i][3])));
      Array4d slack = side.error + 8 * unit_roundoff * side.size;
      if (!side.polynomial) {
        const Array4d largest = side.box.magnitude();
        slack = (side.error + largest * side.error[3]) * (1.001 / (side.weight * (1 - side.weight_spread))) +
                16 * unit_roundoff * largest;
      }
      // The second term is for products below the range of normal numbers.
      const Array4d widening = times(absolute(c), slack) + 0x1p-1000;
      result.lower -= widening;
      result.upper += widening;
      return result;
    };
    const Bounds a = bounds(first);
    const Bounds b = bounds(second);
    for (long k = 0; k < static_cast<long>(N); ++k)
      if (a.upper[k] < b.lower[k] || b.upper[k] < a.lower[k]) return true;
    return false;
  }

  /// A point near both parts.
  Array4d middle() const {
    Array4d result = 0.5 * (first.box.lower.max(second.box.lower) + first.box.upper.min(second.box.upper));
    result[3] = 0;
    return result;
  }

  /// The parameter along which the points are spread most.
  std::size_t widest_axis() const {
    std::size_t result = 0;
    double widest = -1;
    const auto look = [&](const auto& side, std::size_t axis, std::size_t k) {
      const std::size_t stride = side.shape.stride(axis);
      Array4d largest = Array4d::Zero();
      side.shape.for_each_line(axis, [&](std::size_t base) {
        Array4d length = Array4d::Zero();
        for (std::size_t i = 0; i < side.shape.degree[axis]; ++i)
          length += (side.points[base + (i + 1) * stride] - side.points[base + i * stride]).abs();
        largest = largest.max(length);
      });
      const double here = largest.template head<static_cast<int>(N)>().maxCoeff() / side.weight;
      if (here > widest) {
        widest = here;
        result = k;
      }
    };
    for (std::size_t axis = 0; axis < PA; ++axis) look(first, axis, axis);
    for (std::size_t axis = 0; axis < PB; ++axis) look(second, axis, PA + axis);
    return result;
  }

  std::vector<Array4d> scratch_;
};

}  // namespace eliminant::bridge
