// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/overlaps/shared_map.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/intersect/overlaps/patch_inversion.hpp>
#include <eliminant/intersect/patches/net_patches.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ExactNet;
using bridge::ParameterChange;
using bridge::ProjectiveMap;
using symbolic::Integer;
using symbolic::Interval;
using symbolic::Rational;

bool is_in_unit_interval(const std::optional<Rational>& x) { return x && x->sign() >= 0 && !(Rational(1) < *x); }

/// The parameters in [0, 1] whose values are there, too: at most two intervals, which may be points.
std::vector<Interval> common_intervals(const ProjectiveMap& map) {
  std::vector<Rational> ends{0, 1};
  for (const Rational& end : {Rational(0), Rational(1)}) {
    const auto x = map.inverse().at(end);
    if (is_in_unit_interval(x)) ends.push_back(*x);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Interval> result;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!is_in_unit_interval(map.at(ends[i]))) continue;
    const bool continues =
        i > 0 && is_in_unit_interval(map.at((ends[i - 1] + ends[i]) * Rational(Integer(1), Integer(2))));
    if (continues)
      result.back().upper = ends[i];
    else
      result.push_back({ends[i], ends[i]});
  }
  return result;
}

/// The hull of [0, 1] and of the parameters with values there; nullopt where these pass through infinity.
std::optional<Interval> hull_of_both(const ProjectiveMap& map) {
  if (!map.c.is_zero() && is_in_unit_interval(map.a / map.c)) return std::nullopt;
  Interval hull{0, 1};
  for (const Rational& end : {Rational(0), Rational(1)}) {
    const Rational x = *map.inverse().at(end);
    if (x < hull.lower) hull.lower = x;
    if (hull.upper < x) hull.upper = x;
  }
  return hull;
}

bool is_embedded(const ExactNet& net, const ParameterChange& change, const Context& context) {
  ExactNet hull = net;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto sides = hull_of_both(change.maps[axis]);
    if (!sides) return false;
    hull = bridge::composed(hull, axis, {sides->upper - sides->lower, sides->lower, 0, 1});
  }
  const SurfaceResult itself = intersect_patch_with_itself(patch_of(hull), Options(), context);
  return itself.status == Status::certified && itself.components.empty() && itself.singular_points.empty();
}

/// A grid of points on a patch.
struct PointGrid {
  static constexpr int parts = 16;
  std::vector<std::array<double, 2>> parameters;
  std::vector<Eigen::Array4d> points;

  explicit PointGrid(bridge::PatchJets& patch) {
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; j <= parts; ++j) {
        // Not in their order: a border in common is not to be the only place that is looked at.
        const int p = (7 * i + 5) % (parts + 1);
        const int q = (5 * j + 3) % (parts + 1);
        parameters.push_back({static_cast<double>(p) / parts, static_cast<double>(q) / parts});
        points.push_back(patch.at(parameters.back()[0], parameters.back()[1]).point);
      }
  }

  std::array<double, 2> nearest(const Eigen::Array4d& point) const {
    std::size_t best = 0;
    double least = INFINITY;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double distance = (points[i] - point).head<3>().square().sum();
      if (distance >= least) continue;
      least = distance;
      best = i;
    }
    return parameters[best];
  }
};

/// Pairs of parameters that seem to have one point: a few points of the first patch that lie on the second.
std::vector<std::array<double, 4>> starts(const bridge::ControlNet& first, const bridge::ControlNet& second) {
  bridge::PatchJets own(first);
  bridge::PatchJets other(second);
  const PointGrid candidates(own);
  const PointGrid grid(other);
  double size = 0;
  for (const Eigen::Array4d& point : grid.points) size = std::max(size, point.head<3>().abs().maxCoeff());
  std::vector<std::array<double, 4>> result;
  constexpr std::size_t most = 6;
  constexpr double near = 1e-8;
  for (std::size_t i = 0; i < candidates.points.size() && result.size() < most; ++i) {
    const Eigen::Array4d& point = candidates.points[i];
    const std::array<double, 2> there = parameters_near(other, point, grid.nearest(point));
    const Eigen::Array4d distance = other.at(there[0], there[1]).point - point;
    if (distance.head<3>().abs().maxCoeff() > near * size) continue;
    result.push_back({candidates.parameters[i][0], candidates.parameters[i][1], there[0], there[1]});
  }
  return result;
}

std::optional<ParameterChange> recognised(const PatchNets& first, const PatchNets& second, const Context& context) {
  for (const std::array<double, 4>& start : starts(first.rounded, second.rounded)) {
    context.checkpoint("comparing patches");
    if (auto change = bridge::parameter_change(first.exact, second.exact, start)) return change;
  }
  // The common part may be small beside the first patch.
  for (const std::array<double, 4>& at : starts(second.rounded, first.rounded))
    if (auto change = bridge::parameter_change(first.exact, second.exact, {at[2], at[3], at[0], at[1]})) return change;
  return std::nullopt;
}

double rounded(const Rational& value) {
  const bridge::RealBall ball(value, 64);
  return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
}

/// A projective map without a pole on an interval, in doubles.
struct Course {
  double from = 0;
  double to = 0;
  double image_from = 0;
  double image_to = 0;
  /// How much faster it leaves than it arrives.
  double ratio = 1;

  Course(const ProjectiveMap& map, const Interval& interval)
      : from(rounded(interval.lower)),
        to(rounded(interval.upper)),
        image_from(rounded(*map.at(interval.lower))),
        image_to(rounded(*map.at(interval.upper))) {
    if (interval.lower == interval.upper) return;
    const Rational middle = *map.at((interval.lower + interval.upper) * Rational(Integer(1), Integer(2)));
    ratio = rounded((middle - *map.at(interval.lower)) / (*map.at(interval.upper) - middle));
  }

  double at(double part) const { return part == 1 ? to : from + part * (to - from); }
  double image_at(double part) const {
    if (part == 1) return image_to;
    return image_from + (image_to - image_from) * (ratio * part / (1 - part + ratio * part));
  }
};

class Drawing {
 public:
  Drawing(const bridge::ControlNet& first, const ParameterChange& change, const std::array<Interval, 2>& part,
          double tolerance)
      : jets_(first),
        change_(change),
        part_(part),
        tolerance_(tolerance),
        courses_{Course(change.maps[0], part[0]), Course(change.maps[1], part[1])} {}

  DrawnCurve run() && {
    const bool wide = !(part_[0].lower == part_[0].upper);
    const bool high = !(part_[1].lower == part_[1].upper);
    add({0, 0});
    if (wide) add_side(0, 0, false);
    if (high) add_side(1, wide ? 1 : 0, false);
    if (wide && high) {
      add_side(0, 1, true);
      add_side(1, 0, true);
    }
    // Bounds of all coordinates together; parameters are rounded, too.
    drawn_.error += 1.74 * evaluation_ + 8 * bridge::unit_roundoff * speed();
    return std::move(drawn_);
  }

 private:
  void add(const std::array<double, 2>& place) {
    std::array<double, 4> at{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      at[axis] = courses_[axis].at(place[axis]);
      at[2 + change_.image_axis(axis)] = courses_[axis].image_at(place[axis]);
    }
    const bridge::PatchJets::Value value = jets_.at(at[0], at[1]);
    evaluation_ = std::max(evaluation_, value.error);
    drawn_.parameters.push_back(at);
    drawn_.points.push_back({value.point[0], value.point[1], value.point[2]});
  }

  /// Of the rectangle, where the other parameter is at its lower (0) or upper (1) end; without its first point.
  void add_side(std::size_t along, int other_end, bool backwards) {
    const Course& course = courses_[along];
    const double kept = courses_[1 - along].at(other_end);
    const auto bounds =
        along == 0 ? bounds_on(course.from, course.to, kept, kept) : bounds_on(kept, kept, course.from, course.to);
    const double length = course.to - course.from;
    const double bend =
        bounds ? bounds->second[along == 0 ? 0 : 2].head<3>().matrix().norm() * length * length : INFINITY;
    const double steps = std::clamp(std::ceil(std::sqrt(bend / (8 * tolerance_))), 1.0, 1e6);
    drawn_.error = std::max(drawn_.error, bend / (8 * steps * steps));
    for (double i = 1; i <= steps; ++i) {
      const double part = backwards ? (steps - i) / steps : i / steps;
      std::array<double, 2> place{};
      place[along] = part;
      place[1 - along] = other_end;
      add(place);
    }
  }

  /// Sides and points have no width of their own.
  std::optional<bridge::DerivativeBounds> bounds_on(double a0, double a1, double b0, double b1) const {
    constexpr double reach = 0x1p-20;
    return jets_.bounds_on(a0 - reach, a1 + reach, b0 - reach, b1 + reach);
  }

  double speed() const {
    const auto bounds = bounds_on(courses_[0].from, courses_[0].to, courses_[1].from, courses_[1].to);
    return bounds ? (bounds->first[0] + bounds->first[1]).head<3>().matrix().norm() : INFINITY;
  }

  bridge::PatchJets jets_;
  const ParameterChange& change_;
  const std::array<Interval, 2>& part_;
  double tolerance_;
  std::array<Course, 2> courses_;
  double evaluation_ = 0;
  DrawnCurve drawn_;
};

}  // namespace

bool SharedMap::has_area() const {
  return std::any_of(parts.begin(), parts.end(),
                     [](const auto& part) { return part[0].lower < part[0].upper && part[1].lower < part[1].upper; });
}

std::optional<SharedMap> shared_map(const PatchNets& first, const PatchNets& second, const Context& context) {
  const auto change = recognised(first, second, context);
  if (!change) return std::nullopt;
  SharedMap result;
  result.change = *change;
  for (const Interval& u : common_intervals(change->maps[0]))
    for (const Interval& v : common_intervals(change->maps[1])) result.parts.push_back({u, v});
  result.embedded = is_embedded(first.exact, *change, context);
  return result;
}

DrawnCurve drawn_part(const bridge::ControlNet& first, const ParameterChange& change,
                      const std::array<Interval, 2>& part, double tolerance) {
  return Drawing(first, change, part, tolerance).run();
}

}  // namespace eliminant::intersect
