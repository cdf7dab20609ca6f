// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/bernstein_subdivision.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <eliminant/bridge/branches/pair_test.hpp>

namespace eliminant::bridge {

namespace {

template <std::size_t PA, std::size_t PB>
class Subdivision {
 public:
  static constexpr std::size_t N = PA + PB;

  Subdivision(const ControlNet& first, const ControlNet& second, const FindContact& find_contact,
              const SubdivisionLimits& limits, const Context& context)
      : first_net_(first), second_net_(second), find_contact_(find_contact), limits_(limits), context_(context) {
    std::copy(first.degrees.begin(), first.degrees.end(), pair_.first.shape.degree.begin());
    std::copy(second.degrees.begin(), second.degrees.end(), pair_.second.shape.degree.begin());
    first_jet_error_ = jet_error(first, pair_.first.shape);
    second_jet_error_ = jet_error(second, pair_.second.shape);
    pair_.first.polynomial = first.polynomial;
    pair_.second.polynomial = second.polynomial;
    stride_ = pair_.first.shape.size() + pair_.second.shape.size();
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
              points_.begin() + static_cast<std::ptrdiff_t>(pair_.first.shape.size()));
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
    if (!bound(pair_.first) || !bound(pair_.second)) {
      result_.complete = false;
      return;
    }
    if (is_outside(frame) || pair_.apart() || is_known(frame)) {
      frames_.pop_back();
      return;
    }
    const double widest = *std::max_element(frame.width.begin(), frame.width.end());
    const Verdict<N> verdict = pair_.examine(widest * limits_.part);
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
    const auto places = narrowed_places(frame, verdict);
    double shrinking = 1;
    for (const auto& [from, to] : places) shrinking *= to - from;
    // A cut in two halves costs as much as narrowing.
    constexpr double worthwhile = 0.5;
    if (shrinking < worthwhile)
      narrow(frame, places);
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
    pair_.first.points = points_.data() + (frames_.size() - 1) * stride_;
    pair_.second.points = pair_.first.points + pair_.first.shape.size();
    pair_.first.error = frame.first_error;
    pair_.second.error = frame.second_error;
  }

  /// Narrowing leaves a margin, which may be all that is left.
  static bool is_outside(const Frame& frame) {
    for (std::size_t k = 0; k < N; ++k)
      if (frame.lower[k] > 1 + place_slack || frame.lower[k] + frame.width[k] < -place_slack) return true;
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
    const std::size_t count = pair_.first.shape.size();
    if (k < PA) {
      widen(frames_[top].first_error, pair_.first, k);
      halve(pair_.first.shape, k, from, to);
      std::copy(from + count, from + stride_, to + count);
    } else {
      widen(frames_[top].second_error, pair_.second, k - PA);
      halve(pair_.second.shape, k - PA, from + count, to + count);
      std::copy(from, from + count, to);
    }
    Frame right = frames_[top];
    right.lower[k] += right.width[k];
    frames_.push_back(right);
  }

  /// The part of each parameter, in [0, 1] of its width, that can hold zeros, and a little more, so that none stays on
  /// its border.
  std::array<std::pair<double, double>, N> narrowed_places(const Frame& frame, const Verdict<N>& verdict) const {
    double widest = 0;
    for (std::size_t k = 0; k < N; ++k) {
      const long i = static_cast<long>(k);
      widest = std::max(widest, (verdict.upper[i] - verdict.lower[i]) * frame.width[k]);
    }
    std::array<std::pair<double, double>, N> places;
    for (std::size_t k = 0; k < N; ++k) {
      const double lower = verdict.lower[static_cast<long>(k)];
      const double upper = verdict.upper[static_cast<long>(k)];
      constexpr double little = 0x1p-6;
      constexpr double least = 0x1p-12;
      // A parameter that is known much better than the others would make the bound of their errors, which is one for
      // all in units of the widths, too large.
      constexpr double thinnest = 0x1p-6;
      const double margin = little * (upper - lower) + least;
      const double spare = std::max(0.0, 0.5 * (thinnest * widest / frame.width[k] - (upper - lower)));
      const double from = std::max(lower - margin - spare, std::min(lower, -1.0) - margin);
      const double to = std::min(upper + margin + spare, std::max(upper, 1.0) + margin);
      constexpr double hardly = 1.9;
      places[k] = to - from > hardly ? std::pair(0.0, 1.0) : std::pair(0.5 * (from + 1), 0.5 * (to + 1));
    }
    return places;
  }

  /// Replaces the pair by these parts of it.
  void narrow(Frame& frame, const std::array<std::pair<double, double>, N>& places) {
    for (std::size_t k = 0; k < N; ++k) {
      const auto [from, to] = places[k];
      if (from == 0 && to == 1) continue;
      const auto restrict_side = [&, from = from, to = to](auto& side, std::size_t axis, Array4d& error) {
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
        restrict_side(pair_.first, k, frame.first_error);
      else
        restrict_side(pair_.second, k - PA, frame.second_error);
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

  /// The difference of both sides, weights multiplied crosswise, with a bound of its error, and its derivatives.
  struct Evaluation {
    Array4d difference;
    Array4d error;
    Columns jacobian{Array4d::Zero(), Array4d::Zero(), Array4d::Zero()};
  };

  Evaluation evaluate(const std::array<double, N>& at) {
    std::array<double, PA> at_first;
    std::array<double, PB> at_second;
    std::copy(at.begin(), at.begin() + PA, at_first.begin());
    std::copy(at.begin() + PA, at.end(), at_second.begin());
    const NetJet<PA> a = jet_at(pair_.first.shape, first_net_.points.data(), at_first, scratch_.data());
    const NetJet<PB> b = jet_at(pair_.second.shape, second_net_.points.data(), at_second, scratch_.data());
    const double beyond = growth_beyond(at);
    const Array4d error_a = beyond * first_jet_error_;
    const Array4d error_b = beyond * second_jet_error_;
    Evaluation result;
    if (pair_.first.polynomial && pair_.second.polynomial) {
      result.difference = a.value - b.value;
      result.error = error_a + error_b + 8 * unit_roundoff * (a.value.abs() + b.value.abs());
      for (std::size_t k = 0; k < N; ++k) result.jacobian[k] = k < PA ? a.partials[k] : Array4d(-b.partials[k - PA]);
      return result;
    }
    const double wa = a.value[3];
    const double wb = b.value[3];
    result.difference = a.value * wb - b.value * wa;
    result.error =
        (error_a * std::fabs(wb) + error_b * std::fabs(wa) + a.value.abs() * error_b[3] + b.value.abs() * error_a[3]) *
            1.001 +
        8 * unit_roundoff * (a.value.abs() * std::fabs(wb) + b.value.abs() * std::fabs(wa));
    for (std::size_t k = 0; k < N; ++k)
      result.jacobian[k] = k < PA ? Array4d(a.partials[k] * wb - b.value * a.partials[k][3])
                                  : Array4d(a.value * b.partials[k - PA][3] - b.partials[k - PA] * wa);
    return result;
  }

  /// How far the one zero of the pair is from these parameters at most, by the contraction of its preconditioned map.
  double distance_bound(const Frame& frame, const Verdict<N>& verdict, const Evaluation& here) const {
    const double scale = 1 / (pair_.first.weight * pair_.second.weight);
    const Array4d offset = times(verdict.preconditioner, here.difference * scale);
    const Array4d bound =
        offset.abs() + times(absolute(verdict.preconditioner), here.error * scale) + 16 * unit_roundoff * offset.abs();
    // The widths are rounded, too.
    const double local = bound.head<static_cast<int>(N)>().maxCoeff() / (1 - verdict.contraction) * (1 + 1e-9);
    return 0.5 * *std::max_element(frame.width.begin(), frame.width.end()) * local;
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
    double radius = infinity;
    for (int round = 0; round < most_steps; ++round) {
      const Evaluation here = evaluate(at);
      const double distance = distance_bound(frame, verdict, here);
      // Must stay within the pair, where the contraction is proven, and the enclosure where the zero is the only one.
      bool within = true;
      for (std::size_t k = 0; k < N; ++k)
        within = within && at[k] - distance > frame.lower[k] + place_slack &&
                 at[k] + distance < frame.lower[k] + frame.width[k] - place_slack;
      if (within && distance < radius) {
        radius = distance;
        best_ = at;
      }
      const auto [inverse, determinant] = adjugate<N>(here.jacobian);
      const Array4d change = times(inverse, here.difference) / determinant;
      double largest_step = 0;
      for (std::size_t k = 0; k < N; ++k) {
        at[k] -= change[static_cast<long>(k)];
        largest_step = std::max(largest_step, std::fabs(change[static_cast<long>(k)]));
      }
      constexpr double at_rest = 1e-16;
      constexpr double rounding = 0x1p-46;
      if (!(largest_step > at_rest)) break;
      if (radius < infinity && distance >= radius && largest_step < rounding) break;
    }
    return radius < limits_.largest_radius && add_zero(frame, radius);
  }

  /// How much more than `jet_error` says the values may be wrong at these parameters.
  double growth_beyond(const std::array<double, N>& at) const {
    double beyond = 0;
    for (const double parameter : at) beyond = std::max({beyond, -parameter, parameter - 1});
    if (beyond < 0.02) return 1;
    return std::exp(2 * beyond * (degree_sum(pair_.first.shape) + degree_sum(pair_.second.shape)));
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
  PairTest<PA, PB> pair_;
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
