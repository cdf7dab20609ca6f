// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/arc_filling.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace eliminant::intersect {

namespace {

/// Of one tube no more points are made.
constexpr double most_parts = 20000;

double largest_width(const ParameterBox& box) {
  double result = 0;
  for (const DoubleInterval& side : box) result = std::max(result, width(side));
  return result;
}

/// How far in space a point is known.
double uncertainty(const SurfacePair& pair, const PointEnclosure& point) {
  double result = 0;
  for (const DoubleInterval& coordinate : pair.point(point.inverted, point.box))
    result = std::max(result, width(coordinate));
  return result;
}

/// The tube around the chord of two points of an arc; nullopt where it is not proven to be of that arc.
std::optional<BranchTube> tube_between(const SurfacePair& pair, std::size_t axis, const PointEnclosure& from,
                                       const PointEnclosure& to) {
  BranchPoint centre{from.inverted, {}};
  std::array<double, 4> slope{};
  double scale = 1;
  const double length = middle(to.box[axis]) - middle(from.box[axis]);
  for (std::size_t i = 0; i < 4; ++i) {
    centre.at[i] = middle(from.box[i]);
    slope[i] = (middle(to.box[i]) - centre.at[i]) / length;
    scale = std::max(scale, std::fabs(centre.at[i]));
  }
  const double slack = 2 * std::max(largest_width(from.box), largest_width(to.box));
  const DoubleInterval range =
      length > 0 ? DoubleInterval(-slack, length + slack) : DoubleInterval(length - slack, slack);
  const double floor = 8 * std::max(largest_width(from.box), largest_width(to.box)) + 1e-15 * scale;
  auto tube = enclose_branch(pair, centre, axis, slope, range, floor);
  if (!tube || !tube->holds(from.box) || !tube->holds(to.box)) return std::nullopt;
  return tube;
}

}  // namespace

double chord_error(const SurfacePair& pair, const BranchTube& tube, const PointEnclosure& start,
                   const PointEnclosure& end) {
  const SpaceBox speed = pair.velocity(tube.centre.inverted, tube.hull, tube.velocity);
  const double length = std::fabs(middle(end.box[tube.axis]) - middle(start.box[tube.axis])) + 1e-15;
  // Between two zeros a function with derivatives in [a, b] stays within (b - a) / 4 times their distance.
  double square = 0;
  for (const DoubleInterval& coordinate : speed) {
    const double deviation = width(coordinate) * length / 4;
    square += deviation * deviation;
  }
  const double ends = std::max(uncertainty(pair, start), uncertainty(pair, end));
  const double result = (std::sqrt(square) + 2 * ends) * (1 + 1e-12);
  return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
}

std::vector<ArcPoint> fill_arc(const SurfacePair& pair, const BranchTube& tube, const PointEnclosure& start,
                               const PointEnclosure& end, double goal) {
  const double whole = chord_error(pair, tube, start, end);
  const ArcPoint last{end, whole};
  goal = std::max(goal, 8 * std::max(uncertainty(pair, start), uncertainty(pair, end)));
  if (!std::isfinite(whole) || whole <= goal) return {last};
  const std::size_t axis = tube.axis;
  const double first = middle(start.box[axis]);
  const double length = middle(end.box[axis]) - first;
  // Errors are as the squares of lengths; shares of the length that the next chord may have.
  const double least = 1 / most_parts;
  double share = std::clamp(std::sqrt(goal / whole), least, 0.5);
  std::vector<ArcPoint> result;
  PointEnclosure at = start;
  std::array<double, 4> direction{};
  for (std::size_t i = 0; i < 4; ++i) direction[i] = middle(tube.velocity[i]);
  double done = 0;
  while (done < 1) {
    double next = done + share;
    if (next > 1 - 0.5 * share) next = 1;
    PointEnclosure to = end;
    if (next < 1) {
      BranchPoint guess{at.inverted, {}};
      const double step = first + next * length - middle(at.box[axis]);
      for (std::size_t i = 0; i < 4; ++i) guess.at[i] = middle(at.box[i]) + direction[i] * step;
      guess.at[axis] = first + next * length;
      const auto enclosure = enclose_branch_point(pair, guess, axis);
      // Not the arc: the rest is one chord, whose error shrinks with its length.
      if (!enclosure || !tube.holds(enclosure->box)) {
        result.push_back({end, chord_error(pair, tube, at, end)});
        return result;
      }
      to = *enclosure;
    }
    const auto part = tube_between(pair, axis, at, to);
    const double error = chord_error(pair, part ? *part : tube, at, to);
    if (part)
      for (std::size_t i = 0; i < 4; ++i) direction[i] = middle(part->velocity[i]);
    if (error > 1.5 * goal && share > least) {
      share = std::max(least, share * std::clamp(0.9 * std::sqrt(goal / error), 0.1, 0.7));
      continue;
    }
    result.push_back({to, error});
    done = next;
    at = to;
    share = std::clamp(share * std::clamp(0.95 * std::sqrt(goal / std::max(error, 1e-300)), 0.5, 2.0), least, 0.5);
  }
  return result;
}

}  // namespace eliminant::intersect
