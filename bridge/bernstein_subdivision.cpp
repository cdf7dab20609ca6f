// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/bernstein_subdivision.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <eliminant/bridge/bezier_part.hpp>

namespace eliminant::bridge {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Bounds in each coordinate.
struct Bounds {
  Array4d lower = Array4d::Constant(infinity);
  Array4d upper = Array4d::Constant(-infinity);

  void take(const Array4d& value) {
    lower = lower.min(value);
    upper = upper.max(value);
  }
  Array4d magnitude() const { return lower.abs().max(upper.abs()); }
};

/// The curve or patch of a pair: where its control points are, and what is known of them.
template <std::size_t P>
struct Side {
  NetShape<P> shape;
  bool polynomial = true;
  Array4d* points = nullptr;
  Array4d error;
  /// Largest absolute value of each homogeneous coordinate, error included.
  Array4d size;
  /// Around the points of the part, weights divided out.
  Bounds box;
  /// Middle of the range of the weights; the weights are this times 1 + delta with |delta| <= weight_spread.
  double weight = 1;
  double weight_spread = 0;
};

/// A square matrix of order N <= 3 by columns; lane i is row i, lanes from N on are 0.
using Columns = std::array<Array4d, 3>;

Array4d times(const Columns& m, const Array4d& v) { return m[0] * v[0] + m[1] * v[1] + m[2] * v[2]; }

Columns absolute(const Columns& m) { return {m[0].abs(), m[1].abs(), m[2].abs()}; }

/// The transposed cofactors of a matrix given by columns, again by columns, and the determinant.
template <std::size_t N>
std::pair<Columns, double> adjugate(const Columns& m) {
  Columns result{Array4d::Zero(), Array4d::Zero(), Array4d::Zero()};
  if constexpr (N == 2) {
    result[0] << m[1][1], -m[0][1], 0, 0;
    result[1] << -m[1][0], m[0][0], 0, 0;
    return {result, m[0][0] * m[1][1] - m[1][0] * m[0][1]};
  } else {
    const auto cross = [](const Array4d& a, const Array4d& b) {
      return Array4d(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0);
    };
    // Row i of the adjugate is orthogonal to the other two columns.
    const std::array<Array4d, 3> rows{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
    for (long k = 0; k < 3; ++k) result[static_cast<std::size_t>(k)] = Array4d(rows[0][k], rows[1][k], rows[2][k], 0);
    return {result, rows[0][0] * m[0][0] + rows[0][1] * m[0][1] + rows[0][2] * m[0][2]};
  }
}

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

template <std::size_t PA, std::size_t PB>
class Subdivision {
 public:
  static constexpr std::size_t N = PA + PB;

  Subdivision(const ControlNet& first, const ControlNet& second, const FindContact& find_contact,
              const SubdivisionLimits& limits, const Context& context)
      : first_net_(first), second_net_(second), find_contact_(find_contact), limits_(limits), context_(context) {
    std::copy(first.degrees.begin(), first.degrees.end(), first_.shape.degree.begin());
    std::copy(second.degrees.begin(), second.degrees.end(), second_.shape.degree.begin());
    first_jet_error_ = jet_error(first, first_.shape);
    second_jet_error_ = jet_error(second, second_.shape);
    first_.polynomial = first.polynomial;
    second_.polynomial = second.polynomial;
    stride_ = first_.shape.size() + second_.shape.size();
    constexpr std::size_t usual_depth = 24;
    points_.resize((usual_depth + 1) * stride_);
    frames_.reserve(usual_depth);
  }

  SubdivisionResult run() && {
    Frame whole;
    whole.lower.fill(0);
    whole.width.fill(1);
    whole.first_error = first_net_.error;
    whole.second_error = second_net_.error;
    std::copy(first_net_.points.begin(), first_net_.points.end(), points_.begin());
    std::copy(second_net_.points.begin(), second_net_.points.end(),
              points_.begin() + static_cast<std::ptrdiff_t>(first_.shape.size()));
    frames_.push_back(whole);
    while (!frames_.empty() && result_.complete) {
      if (++result_.pairs > limits_.most_pairs) {
        result_.complete = false;
        break;
      }
      constexpr unsigned long checked_every = 256;
      if (result_.pairs % checked_every == 0) context_.checkpoint("subdividing");
      step();
    }
    return std::move(result_);
  }

 private:
  /// The places of parts are rounded: by less than this in all the cuts and narrowings that lead to a part.
  static constexpr double place_slack = 0x1p-44;

  /// A pair of parts: its place in the parameters, and the errors of its control points, which lie at its place in
  /// points_.
  struct Frame {
    std::array<double, N> lower;
    std::array<double, N> width;
    Array4d first_error;
    Array4d second_error;
  };
  struct KnownZero {
    IsolatedZero zero;
    /// The only zero in that box of parameters.
    std::array<double, N> lower;
    std::array<double, N> upper;
    bool is_contact = false;
  };

  /// Deals with the topmost pair.
  void step() {
    Frame& frame = frames_.back();
    load(frame);
    if (!bound(first_) || !bound(second_)) {
      result_.complete = false;
      return;
    }
    if (apart() || is_known(frame)) {
      frames_.pop_back();
      return;
    }
    const double widest = *std::max_element(frame.width.begin(), frame.width.end());
    const Verdict<N> verdict = examine(widest);
    if (verdict.excluded || (verdict.one_zero && settle(frame, verdict))) {
      frames_.pop_back();
      return;
    }
    if (widest < look_for_contact_ && verdict.nearly_parallel && look_for_contact(frame) && is_known(frame)) {
      frames_.pop_back();
      return;
    }
    if (widest < limits_.smallest_width) {
      leave_open(frame);
      return;
    }
    double shrinking = 1;
    for (std::size_t k = 0; k < N; ++k)
      shrinking *= 0.5 * (verdict.upper[static_cast<long>(k)] - verdict.lower[static_cast<long>(k)]);
    // A cut in two halves costs as much as narrowing.
    constexpr double worthwhile = 0.5;
    if (shrinking < worthwhile)
      narrow(frame, verdict);
    else
      cut(verdict.axis);
  }

  /// True when a contact was found near the pair. Each failure makes the next attempt wait for much smaller parts.
  bool look_for_contact(const Frame& frame) {
    if (!find_contact_) return false;
    const auto beside = [&](const KnownZero& other) {
      for (std::size_t k = 0; k < N; ++k)
        if (frame.lower[k] > other.upper[k] || frame.lower[k] + frame.width[k] < other.lower[k]) return false;
      return other.is_contact;
    };
    if (std::any_of(known_.begin(), known_.end(), beside)) return false;
    std::array<double, 3> near{};
    for (std::size_t k = 0; k < N; ++k) near[k] = frame.lower[k] + 0.5 * frame.width[k];
    // Parts of width w next to a contact of order k are undecided as far from it as about w^(2 / k).
    const double reach = 2 * std::sqrt(*std::max_element(frame.width.begin(), frame.width.end()));
    const std::optional<OpenBox> box = find_contact_(near, reach);
    const auto same = [&](const KnownZero& other) {
      const double middle = 0.5 * (box->lower[0] + box->upper[0]);
      return other.is_contact && other.lower[0] < middle && middle < other.upper[0];
    };
    if (!box || std::any_of(known_.begin(), known_.end(), same)) {
      look_for_contact_ *= 0.125;
      return false;
    }
    KnownZero contact;
    contact.is_contact = true;
    for (std::size_t k = 0; k < N; ++k) {
      contact.lower[k] = box->lower[k] + place_slack;
      contact.upper[k] = box->upper[k] - place_slack;
    }
    known_.push_back(contact);
    return true;
  }

  void load(const Frame& frame) {
    first_.points = points_.data() + (frames_.size() - 1) * stride_;
    second_.points = first_.points + first_.shape.size();
    first_.error = frame.first_error;
    second_.error = frame.second_error;
  }

  /// False when a weight may not be positive.
  template <std::size_t P>
  static bool bound(Side<P>& side) {
    const std::size_t count = side.shape.size();
    Bounds homogeneous;
    for (std::size_t i = 0; i < count; ++i) homogeneous.take(side.points[i]);
    side.size = homogeneous.magnitude() + side.error;
    if (side.polynomial) {
      side.box = homogeneous;
      side.box.lower -= side.error;
      side.box.upper += side.error;
      return true;
    }
    const double lowest = homogeneous.lower[3] - side.error[3];
    const double highest = homogeneous.upper[3] + side.error[3];
    if (!(lowest > side.error[3]) || !(highest < infinity)) return false;
    side.weight = 0.5 * (lowest + highest);
    side.weight_spread = (0.5 * (highest - lowest) / side.weight) * (1 + 8 * unit_roundoff) + 4 * unit_roundoff;
    side.box = Bounds();
    for (std::size_t i = 0; i < count; ++i) side.box.take(side.points[i] / side.points[i][3]);
    const Array4d largest = side.box.magnitude();
    const Array4d slack = (side.error + largest * side.error[3]) * (1.001 / lowest) + 4 * unit_roundoff * largest;
    side.box.lower -= slack;
    side.box.upper += slack;
    return true;
  }

  bool apart() const {
    for (long k = 0; k < static_cast<long>(N); ++k)
      if (first_.box.upper[k] < second_.box.lower[k] || second_.box.upper[k] < first_.box.lower[k]) return true;
    return false;
  }

  /// True when the pair lies where a known zero is the only one.
  bool is_known(const Frame& frame) const {
    return std::any_of(known_.begin(), known_.end(), [&](const KnownZero& zero) {
      for (std::size_t k = 0; k < N; ++k)
        if (frame.lower[k] < zero.lower[k] || frame.lower[k] + frame.width[k] > zero.upper[k]) return false;
      return true;
    });
  }

  /// The derivative by a local parameter from one end to the other, weights divided out.
  template <std::size_t P>
  static Array4d secant(const Side<P>& side, std::size_t axis) {
    const auto point = [&](std::size_t i) -> Array4d {
      return side.polynomial ? side.points[i] : side.points[i] / side.points[i][3];
    };
    const std::size_t last = side.shape.size() - 1;
    if constexpr (P == 1) {
      return 0.5 * (point(last) - point(0));
    } else {
      const std::size_t end = side.shape.degree[axis] * side.shape.stride(axis);
      return 0.25 * ((point(end) - point(0)) + (point(last) - point(last - end)));
    }
  }

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

  template <std::size_t P>
  Preconditioned<P> precondition(const Side<P>& side, const Columns& c, const Array4d& shift, bool rational,
                                 double sign, std::size_t first_axis) {
    Preconditioned<P> result;
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
    const Bounds a = bounds(first_);
    const Bounds b = bounds(second_);
    for (long k = 0; k < static_cast<long>(N); ++k)
      if (a.upper[k] < b.lower[k] || b.upper[k] < a.lower[k]) return true;
    return false;
  }

  Verdict<N> examine(double widest) {
    Verdict<N> verdict;
    Columns jacobian{Array4d::Zero(), Array4d::Zero(), Array4d::Zero()};
    Array4d lengths = Array4d::Zero();
    for (std::size_t k = 0; k < N; ++k) {
      jacobian[k] = k < PA ? secant(first_, k) : Array4d(-secant(second_, k - PA));
      jacobian[k][3] = 0;
      if (N == 2) jacobian[k][2] = 0;
      lengths[static_cast<long>(k)] = std::sqrt(jacobian[k].square().sum());
    }
    auto [inverse, determinant] = adjugate<N>(jacobian);
    double volume = 1;
    for (std::size_t k = 0; k < N; ++k) volume *= lengths[static_cast<long>(k)];
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
    const bool rational = !first_.polynomial || !second_.polynomial;
    if (rational && separated(inverse)) {
      verdict.excluded = true;
      return verdict;
    }
    const Array4d shift = rational ? middle() : Array4d::Zero();
    const Preconditioned<PA> a = precondition(first_, inverse, shift, rational, 1, 0);
    const Preconditioned<PB> b = precondition(second_, inverse, shift, rational, -1, PA);

    // What rounding and the errors of the control points add, in units of the local coordinates.
    const Array4d size = moved_size(first_, shift) + moved_size(second_, shift);
    const Array4d error =
        times(absolute(inverse), moved_error(first_, shift) + moved_error(second_, shift) + 16 * unit_roundoff * size) +
        16 * unit_roundoff;
    Array4d remainder = Array4d::Zero();
    if (rational) {
      const Array4d largest_a = a.magnitude + error;
      const Array4d largest_b = b.magnitude + error;
      remainder = (largest_a * second_.weight_spread + largest_b * first_.weight_spread) * (1 + 1e-12);
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
    for (std::size_t axis = 0; axis < PA; ++axis) slope_of(first_, second_, a, b, axis, axis);
    for (std::size_t axis = 0; axis < PB; ++axis) slope_of(second_, first_, b, a, axis, PA + axis);

    bool into_itself = true;
    for (std::size_t k = 0; k < N; ++k) {
      const long i = static_cast<long>(k);
      if (!(lower[i] <= 1) || !(upper[i] >= -1)) {
        verdict.excluded = std::isfinite(lower[i]) && std::isfinite(upper[i]);
        if (verdict.excluded) return verdict;
      }
      into_itself = into_itself && lower[i] > -1 && upper[i] < 1;
      verdict.lower[i] = std::max(lower[i], -1.0);
      verdict.upper[i] = std::min(upper[i], 1.0);
    }
    verdict.contraction = row_sums.head<static_cast<int>(N)>().maxCoeff();
    constexpr double at_most = 0.95;
    verdict.one_zero = into_itself && verdict.contraction < at_most;
    column_sizes.head<static_cast<int>(N)>().maxCoeff(&verdict.axis);
    return verdict;
  }

  /// A point near both parts.
  Array4d middle() const {
    Array4d result = 0.5 * (first_.box.lower.max(second_.box.lower) + first_.box.upper.min(second_.box.upper));
    result[3] = 0;
    return result;
  }
  template <std::size_t P>
  static Array4d moved_size(const Side<P>& side, const Array4d& shift) {
    return (side.size + shift.abs() * side.size[3]) / side.weight;
  }
  template <std::size_t P>
  static Array4d moved_error(const Side<P>& side, const Array4d& shift) {
    return (side.error + shift.abs() * side.error[3]) / side.weight;
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
    for (std::size_t axis = 0; axis < PA; ++axis) look(first_, axis, axis);
    for (std::size_t axis = 0; axis < PB; ++axis) look(second_, axis, PA + axis);
    return result;
  }

  void cut(std::size_t k) {
    const std::size_t top = frames_.size() - 1;
    points_.resize(std::max(points_.size(), (top + 2) * stride_));
    Array4d* const from = points_.data() + top * stride_;
    Array4d* const to = from + stride_;
    frames_[top].width[k] *= 0.5;
    const auto widen = [&](Array4d& error, const auto& side, std::size_t axis) {
      error += static_cast<double>(side.shape.degree[axis]) * 2 * unit_roundoff * side.size;
      if (side.polynomial) error[3] = 0;
    };
    const std::size_t count = first_.shape.size();
    if (k < PA) {
      widen(frames_[top].first_error, first_, k);
      halve(first_.shape, k, from, to);
      std::copy(from + count, from + stride_, to + count);
    } else {
      widen(frames_[top].second_error, second_, k - PA);
      halve(second_.shape, k - PA, from + count, to + count);
      std::copy(from, from + count, to);
    }
    Frame right = frames_[top];
    right.lower[k] += right.width[k];
    frames_.push_back(right);
  }

  /// Replaces the pair by the part of it that can hold zeros, and a little more, so that none stays on its border.
  void narrow(Frame& frame, const Verdict<N>& verdict) {
    for (std::size_t k = 0; k < N; ++k) {
      const double lower = verdict.lower[static_cast<long>(k)];
      const double upper = verdict.upper[static_cast<long>(k)];
      constexpr double little = 0x1p-6;
      constexpr double least = 0x1p-12;
      const double margin = little * (upper - lower) + least;
      if (upper - lower + 2 * margin > 1.9) continue;
      const double from = 0.5 * (lower - margin + 1);
      const double to = 0.5 * (upper + margin + 1);
      const auto restrict_side = [&](auto& side, std::size_t axis, Array4d& error) {
        restrict_to(side.shape, axis, from, to, side.points);
        // Beyond [0, 1] values and errors grow by less than this factor: (1 + 2 beyond)^degree.
        const auto degree = static_cast<double>(side.shape.degree[axis]);
        const double beyond = std::max(-from, to - 1);
        const double growth = beyond > 0 ? std::exp(2 * beyond * degree) * (1 + 8 * unit_roundoff) : 1;
        error = growth * (error + 10 * degree * unit_roundoff * side.size);
        side.size *= growth;
        if (side.polynomial) error[3] = 0;
      };
      if (k < PA)
        restrict_side(first_, k, frame.first_error);
      else
        restrict_side(second_, k - PA, frame.second_error);
      frame.lower[k] += from * frame.width[k];
      frame.width[k] *= to - from;
    }
  }

  void leave_open(const Frame& frame) {
    OpenBox box;
    for (std::size_t k = 0; k < N; ++k) {
      box.lower[k] = frame.lower[k];
      box.upper[k] = frame.lower[k] + frame.width[k];
    }
    frames_.pop_back();
    result_.open.push_back(box);
    if (result_.open.size() >= limits_.most_open && !frames_.empty()) result_.complete = false;
  }

  /// Newton's steps to the one zero of a pair, and how near they came. False when that is not near enough.
  bool settle(const Frame& frame, const Verdict<N>& verdict) {
    std::array<double, N> at;
    for (std::size_t k = 0; k < N; ++k) {
      const double local = 0.5 * (verdict.lower[static_cast<long>(k)] + verdict.upper[static_cast<long>(k)]);
      at[k] = frame.lower[k] + frame.width[k] * (0.5 + 0.5 * local);
    }
    scratch_.resize(std::max(scratch_.size(), std::max(first_net_.points.size(), second_net_.points.size())));
    constexpr int most_steps = 12;
    Array4d change = Array4d::Zero();
    double radius = infinity;
    for (int round = 0; round < most_steps; ++round) {
      std::array<double, PA> at_first;
      std::array<double, PB> at_second;
      std::copy(at.begin(), at.begin() + PA, at_first.begin());
      std::copy(at.begin() + PA, at.end(), at_second.begin());
      const NetJet<PA> a = jet_at(first_.shape, first_net_.points.data(), at_first, scratch_.data());
      const NetJet<PB> b = jet_at(second_.shape, second_net_.points.data(), at_second, scratch_.data());
      const bool rational = !first_.polynomial || !second_.polynomial;
      const Array4d difference = rational ? Array4d(a.value * b.value[3] - b.value * a.value[3]) : a.value - b.value;
      // In the parameters of the whole; the bound is that of the preconditioned map of the pair.
      const double scale = 1 / (first_.weight * second_.weight);
      const double beyond = growth_beyond(at);
      const Array4d error_a = beyond * first_jet_error_;
      const Array4d error_b = beyond * second_jet_error_;
      Array4d error = error_a + error_b + 8 * unit_roundoff * (a.value.abs() + b.value.abs());
      if (rational)
        error = (error_a * std::fabs(b.value[3]) + error_b * std::fabs(a.value[3]) + a.value.abs() * error_b[3] +
                 b.value.abs() * error_a[3]) *
                    1.001 +
                8 * unit_roundoff * (a.value.abs() * std::fabs(b.value[3]) + b.value.abs() * std::fabs(a.value[3]));
      const Array4d offset = times(verdict.preconditioner, difference * scale);
      const Array4d bound =
          offset.abs() + times(absolute(verdict.preconditioner), error * scale) + 16 * unit_roundoff * offset.abs();
      // The widths are rounded, too.
      const double local_radius = bound.head<static_cast<int>(N)>().maxCoeff() / (1 - verdict.contraction) * (1 + 1e-9);
      double largest_step = 0;
      double here = 0;
      for (std::size_t k = 0; k < N; ++k) here = std::max(here, 0.5 * frame.width[k] * local_radius);
      // Must stay within the pair, where the contraction is proven, and the enclosure where the zero is the only one.
      bool within = true;
      for (std::size_t k = 0; k < N; ++k)
        within = within && at[k] - here > frame.lower[k] + place_slack &&
                 at[k] + here < frame.lower[k] + frame.width[k] - place_slack;
      if (within && here < radius) {
        radius = here;
        best_ = at;
      }
      // Newton's step with the derivative here.
      Columns jacobian{Array4d::Zero(), Array4d::Zero(), Array4d::Zero()};
      for (std::size_t k = 0; k < N; ++k) {
        jacobian[k] = k < PA ? a.partials[k] : Array4d(-b.partials[k - PA]);
        if (rational)
          jacobian[k] = k < PA ? Array4d(a.partials[k] * b.value[3] - b.value * a.partials[k][3])
                               : Array4d(a.value * b.partials[k - PA][3] - b.partials[k - PA] * a.value[3]);
      }
      const auto [inverse, determinant] = adjugate<N>(jacobian);
      change = times(inverse, difference) / determinant;
      for (std::size_t k = 0; k < N; ++k) {
        at[k] -= change[static_cast<long>(k)];
        largest_step = std::max(largest_step, std::fabs(change[static_cast<long>(k)]));
      }
      constexpr double at_rest = 1e-16;
      if (!(largest_step > at_rest)) break;
      constexpr double rounding = 0x1p-46;
      if (radius < infinity && here >= radius && largest_step < rounding) break;
    }
    // Wide enough to be unique in the pair, and narrow enough to be useful.
    constexpr double accurate = 0x1p-26;
    if (!(radius < accurate)) return false;
    return add_zero(frame, radius);
  }

  /// How much more than `jet_error` says the values may be wrong at these parameters.
  double growth_beyond(const std::array<double, N>& at) const {
    double beyond = 0;
    for (const double parameter : at) beyond = std::max({beyond, -parameter, parameter - 1});
    if (beyond < 0.02) return 1;
    return std::exp(2 * beyond * (degree_sum(first_.shape) + degree_sum(second_.shape)));
  }
  template <std::size_t P>
  static double degree_sum(const NetShape<P>& shape) {
    double result = 0;
    for (const std::size_t d : shape.degree) result += static_cast<double>(d);
    return result;
  }

  /// Of the values of jet_at within a fiftieth of the domain.
  template <std::size_t P>
  static Array4d jet_error(const ControlNet& net, const NetShape<P>& shape) {
    Array4d size = Array4d::Zero();
    for (const Array4d& point : net.points) size = size.max(point.abs());
    const double degrees = degree_sum(shape);
    return std::exp(0.04 * degrees) * (net.error + 4 * degrees * unit_roundoff * size);
  }

  /// False when it cannot be told from a zero known already.
  bool add_zero(const Frame& frame, double radius) {
    KnownZero zero;
    double isolation = infinity;
    for (std::size_t k = 0; k < N; ++k) {
      zero.lower[k] = frame.lower[k] + place_slack;
      zero.upper[k] = frame.lower[k] + frame.width[k] - place_slack;
      zero.zero.parameters[k] = best_[k];
      isolation = std::min({isolation, best_[k] - zero.lower[k], zero.upper[k] - best_[k]});
    }
    zero.zero.radius = radius;
    zero.zero.isolation = isolation;
    const auto contains = [&](const KnownZero& box, const IsolatedZero& other) {
      for (std::size_t k = 0; k < N; ++k)
        if (other.parameters[k] - other.radius < box.lower[k] || other.parameters[k] + other.radius > box.upper[k])
          return false;
      return true;
    };
    const bool known = std::any_of(known_.begin(), known_.end(), [&](const KnownZero& other) {
      return contains(other, zero.zero) || (!other.is_contact && contains(zero, other.zero));
    });
    const auto touches = [&](const KnownZero& other) {
      for (std::size_t k = 0; k < N; ++k)
        if (std::fabs(other.zero.parameters[k] - best_[k]) > (other.zero.radius + radius) * (1 + 1e-9) + 0x1p-50)
          return false;
      return !other.is_contact;
    };
    // In the box of neither, but perhaps the same: then smaller parts have to tell.
    if (!known && std::any_of(known_.begin(), known_.end(), touches)) return false;
    bool outside = false;
    for (std::size_t k = 0; k < N; ++k) outside = outside || best_[k] + radius < 0 || best_[k] - radius > 1;
    known_.push_back(zero);
    if (!known && !outside) result_.zeros.push_back(zero.zero);
    return true;
  }

  const ControlNet& first_net_;
  const ControlNet& second_net_;
  const FindContact& find_contact_;
  const SubdivisionLimits& limits_;
  const Context& context_;
  Side<PA> first_;
  Side<PB> second_;
  Array4d first_jet_error_;
  Array4d second_jet_error_;
  std::size_t stride_ = 0;
  std::vector<Array4d> points_;
  std::vector<Frame> frames_;
  std::vector<Array4d> scratch_;
  std::vector<KnownZero> known_;
  std::array<double, N> best_{};
  /// Parts narrower than this may be next to a contact.
  double look_for_contact_ = 0x1p-5;
  SubdivisionResult result_;
};

}  // namespace

SubdivisionResult bernstein_subdivision(const ControlNet& first, const ControlNet& second,
                                        const FindContact& find_contact, const SubdivisionLimits& limits,
                                        const Context& context) {
  if (second.parameters() == 1) return Subdivision<1, 1>(first, second, find_contact, limits, context).run();
  return Subdivision<1, 2>(first, second, find_contact, limits, context).run();
}

}  // namespace eliminant::bridge
