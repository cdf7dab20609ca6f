// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/tube_tracing.hpp>

#include <cmath>
#include <limits>

#include <eliminant/intersect/whole_surfaces/arc_filling.hpp>
#include <eliminant/symbolic/elimination/bivariate_factors.hpp>

namespace eliminant::intersect {

namespace {

BranchPoint centre_of(const PointEnclosure& point) {
  BranchPoint result{point.inverted, {}};
  for (std::size_t i = 0; i < 4; ++i) result.at[i] = middle(point.box[i]);
  return result;
}

double largest_width(const ParameterBox& box) {
  double result = 0;
  for (const DoubleInterval& side : box) result = std::max(result, width(side));
  return result;
}

/// Charts in which every parameter is at most about 1; near base points at their origins both are inverted again.
PointEnclosure in_good_charts(const SurfacePair& pair, const PointEnclosure& point, std::array<double, 4>& direction) {
  PointEnclosure result = point;
  for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
    std::array<bool, 2> charts{point.inverted[k], point.inverted[k + 1]};
    const SurfaceCharts& surface = k == 0 ? pair.first() : pair.second();
    const std::array<bool, 2> opposite{!charts[0], !charts[1]};
    const bool both_large = std::fabs(middle(point.box[k])) > 0.8 && std::fabs(middle(point.box[k + 1])) > 0.8;
    if (both_large && surface.has_base_point(opposite)) continue;
    for (std::size_t i = 0; i < 2; ++i)
      if (std::fabs(middle(point.box[k + i])) > 1.25) charts[i] = !charts[i];
    if (surface.has_base_point(charts)) charts = {!charts[0], !charts[1]};
    result.inverted[k] = charts[0];
    result.inverted[k + 1] = charts[1];
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (result.inverted[i] != point.inverted[i]) direction[i] /= -middle(point.box[i]) * middle(point.box[i]);
  result.box = in_charts(point.box, point.inverted, result.inverted);
  for (std::size_t i = 0; i < 4; ++i)
    if (!result.box[i].is_finite()) return point;
  return result;
}

}  // namespace

WeightFactor::Jet WeightFactor::jet(const Charts& inverted, const ParameterBox& box) const {
  const std::array<DoubleInterval, 2> at{box[first_parameter], box[first_parameter + 1]};
  Jet result;
  for (std::size_t i = degree[0] + 1; i-- > 0;) {
    DoubleInterval row;
    DoubleInterval slope;
    const std::size_t power = inverted[first_parameter] ? degree[0] - i : i;
    for (std::size_t j = degree[1] + 1; j-- > 0;) {
      slope = slope * at[1] + row;
      const std::size_t column = inverted[first_parameter + 1] ? degree[1] - j : j;
      row = row * at[1] + coefficients[power * (degree[1] + 1) + column];
    }
    result.derivative[0] = result.derivative[0] * at[0] + result.value;
    result.derivative[1] = result.derivative[1] * at[0] + slope;
    result.value = result.value * at[0] + row;
  }
  return result;
}

std::vector<WeightFactor> weight_factors(const symbolic::RationalSurface& first,
                                         const symbolic::RationalSurface& second, std::uint64_t seed) {
  std::vector<WeightFactor> result;
  for (const std::size_t parameter : {std::size_t{0}, std::size_t{2}}) {
    const symbolic::RationalSurface& surface = parameter == 0 ? first : second;
    const symbolic::Polynomial& weight = surface.coordinates()[3];
    if (weight.is_zero()) continue;
    const auto [m, n] = surface.bidegree();
    if (weight.degree(0) < m) result.push_back({parameter, {1, 0}, {DoubleInterval(1), DoubleInterval(0)}});
    if (weight.degree(1) < n) result.push_back({parameter, {0, 1}, {DoubleInterval(1), DoubleInterval(0)}});
    if (weight.is_constant()) continue;
    for (const symbolic::BivariateFactor& part : symbolic::bivariate_factors(weight, seed)) {
      WeightFactor factor{parameter, {}, {}};
      factor.degree = {static_cast<std::size_t>(part.factor.degree(0)),
                       static_cast<std::size_t>(part.factor.degree(1))};
      factor.coefficients.resize((factor.degree[0] + 1) * (factor.degree[1] + 1));
      for (const auto& term : part.factor.terms())
        factor.coefficients[term.exponents[0] * (factor.degree[1] + 1) + term.exponents[1]] = enclose(term.coefficient);
      result.push_back(std::move(factor));
    }
  }
  return result;
}

TubeTracer::Crossing TubeTracer::crossing(const BranchSegment& segment, const BranchSeed& seed) const {
  const BranchTube& tube = segment.tube;
  const ParameterBox goal = in_charts(seed.point.box, seed.point.inverted, tube.centre.inverted);
  for (std::size_t i = 0; i < 4; ++i)
    if (!overlap(goal[i], tube.hull[i])) return {};
  // From here on the seed may be on the segment.
  const DoubleInterval& start = segment.start.box[seed.axis];
  const DoubleInterval& end = segment.end.box[seed.axis];
  const DoubleInterval& value = goal[seed.axis];
  const DoubleInterval speed = tube.velocity[seed.axis];
  if (!speed.excludes_zero()) return {Passage::undecided};
  const bool rises = start.lower < end.lower;
  const DoubleInterval& below = rises ? start : end;
  const DoubleInterval& above = rises ? end : start;
  if (value.upper < below.lower || above.upper < value.lower) return {};
  if (!(below.upper < value.lower && value.upper < above.lower)) return {Passage::undecided};
  // The branch passes the value once, at this point: is it the seed?
  BranchPoint point = tube.centre;
  const double share = (middle(value) - middle(start)) / (middle(end) - middle(start));
  for (std::size_t i = 0; i < 4; ++i)
    point.at[i] = middle(segment.start.box[i]) + share * (middle(segment.end.box[i]) - middle(segment.start.box[i]));
  point.at[seed.axis] = middle(value);
  const auto enclosure = enclose_branch_point(pair_, point, seed.axis);
  if (!enclosure || !tube.holds(enclosure->box)) return {Passage::undecided};
  const std::size_t other = 3 - seed.axis;
  const DoubleInterval isolated = in_charts({seed.isolated, seed.isolated, seed.isolated, seed.isolated},
                                            seed.point.inverted, tube.centre.inverted)[other];
  if (!overlap(enclosure->box[other], isolated)) return {};
  for (std::size_t i = 0; i < 4; ++i)
    if (!overlap(enclosure->box[i], goal[i])) return {};
  if (!contains(isolated, enclosure->box[other])) return {Passage::undecided};
  // In the chart of the inverse increasing values of the parameter are decreasing ones, unless both are inverted.
  const bool reversed = tube.centre.inverted[seed.axis] != seed.point.inverted[seed.axis];
  return {Passage::passes, rises != reversed};
}

std::optional<bool> TubeTracer::crosses_infinity(const BranchSegment& segment) const {
  bool crosses = false;
  for (const WeightFactor& factor : weights_) {
    const auto on_hull = factor.jet(segment.tube.centre.inverted, segment.tube.hull);
    if (on_hull.value.excludes_zero()) continue;
    const DoubleInterval speed = on_hull.derivative[0] * segment.tube.velocity[factor.first_parameter] +
                                 on_hull.derivative[1] * segment.tube.velocity[factor.first_parameter + 1];
    if (!speed.excludes_zero()) return std::nullopt;
    const DoubleInterval start = factor.jet(segment.start.inverted, segment.start.box).value;
    const DoubleInterval end = factor.jet(segment.end.inverted, segment.end.box).value;
    if (!start.excludes_zero() || !end.excludes_zero()) return std::nullopt;
    crosses = crosses || (start.lower > 0) != (end.lower > 0);
  }
  return crosses;
}

std::optional<BranchSegment> TubeTracer::advance(const PointEnclosure& from, const std::array<double, 4>& direction,
                                                 double step) const {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (std::fabs(direction[i]) > std::fabs(direction[axis])) axis = i;
  std::array<double, 4> slope{};
  for (std::size_t i = 0; i < 4; ++i) slope[i] = direction[i] / direction[axis];
  const BranchPoint centre = centre_of(from);
  double scale = 1;
  for (const double x : centre.at) scale = std::max(scale, std::fabs(x));
  const double length = std::copysign(step * scale, direction[axis]);
  const double slack = 2 * largest_width(from.box);
  const DoubleInterval range =
      length > 0 ? DoubleInterval(-slack, length * (1 + 1e-9)) : DoubleInterval(length * (1 + 1e-9), slack);
  auto tube = enclose_branch(pair_, centre, axis, slope, range, 8 * largest_width(from.box) + 1e-15 * scale);
  if (!tube || !tube->holds(from.box)) return std::nullopt;
  BranchPoint next = centre;
  for (std::size_t i = 0; i < 4; ++i) next.at[i] += slope[i] * length;
  const auto end = enclose_branch_point(pair_, next, axis);
  if (!end || !tube->holds(end->box)) return std::nullopt;
  BranchSegment segment;
  segment.tube = *std::move(tube);
  segment.start = from;
  segment.end = *end;
  segment.error = chord_error(pair_, segment.tube, segment.start, segment.end);
  return segment;
}

TracedBranch TubeTracer::trace(std::size_t seed, bool forward, std::size_t origin) const {
  TracedBranch result;
  PointEnclosure at = seeds_[seed].point;
  auto direction = branch_direction(pair_, centre_of(at));
  if (!direction) return result;
  if (((*direction)[seeds_[seed].axis] > 0) != forward)
    for (double& d : *direction) d = -d;
  double step = limits_.first_step;
  bool unbounded = seeds_[seed].unbounded[forward ? 1 : 0];
  double farthest = limits_.size;
  for (const DoubleInterval& x : pair_.point(at.inverted, at.box))
    if (x.is_finite()) farthest = std::max(farthest, x.magnitude());
  farthest *= limits_.reach;
  while (result.segments.size() < limits_.most_segments) {
    if (result.segments.size() % 64 == 0) context_.checkpoint("tracing branches");
    at = in_good_charts(pair_, at, *direction);
    for (const DoubleInterval& x : at.box)
      if (x.magnitude() > limits_.largest_parameter) return result;
    for (const DoubleInterval& x : pair_.point(at.inverted, at.box))
      if (unbounded && x.is_finite() && x.magnitude() > farthest) return result;
    auto tangent = branch_direction(pair_, centre_of(at));
    if (!tangent) return result;
    double cosine = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += (*tangent)[i] * (*direction)[i];
    if (cosine < 0)
      for (double& d : *tangent) d = -d;
    std::optional<BranchSegment> segment;
    std::vector<SeedPassage> passages;
    for (; step >= limits_.least_step; step /= 2) {
      segment = advance(at, *tangent, step);
      if (!segment) continue;
      if (std::isfinite(segment->error)) {
        double reach = limits_.size;
        for (const DoubleInterval& x : pair_.point(segment->end.inverted, segment->end.box))
          reach = std::max(reach, std::fabs(middle(x)));
        if (segment->error > limits_.tolerance * reach && step > 1e-3) {
          segment.reset();
          continue;
        }
      }
      const auto crosses = crosses_infinity(*segment);
      bool clear = crosses.has_value();
      // Next to a passage through infinity shorter tubes know that they do not reach it.
      if (clear && !*crosses && !std::isfinite(segment->error) && step > 1e-5) clear = false;
      if (clear) segment->crosses_infinity = *crosses;
      passages.clear();
      const bool leaving = result.segments.empty();
      for (std::size_t k = 0; clear && k < seeds_.size(); ++k) {
        if (leaving && k == seed) continue;
        const Crossing found = crossing(*segment, seeds_[k]);
        if (found.passage == Passage::undecided) clear = false;
        if (found.passage == Passage::passes) passages.push_back({k, result.segments.size(), found.forward});
      }
      if (clear) break;
      segment.reset();
    }
    if (!segment) return result;
    *direction = *tangent;
    at = segment->end;
    result.segments.push_back(*std::move(segment));
    for (const SeedPassage& passage : passages) {
      result.passages.push_back(passage);
      unbounded = seeds_[passage.seed].unbounded[passage.forward ? 1 : 0];
      if (passage.seed == origin) {
        result.closed = true;
        return result;
      }
    }
    step = std::min(1.7 * step, limits_.largest_step);
  }
  return result;
}

}  // namespace eliminant::intersect
