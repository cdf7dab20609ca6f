// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/whole_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace eliminant::intersect {

std::optional<std::size_t> WholeCurve::turn_at_vertex(ArcEnd& end) const {
  const std::size_t index = arcs_.arcs()[end.arc].ends[end.end];
  const TopologyVertex& vertex = arcs_.topology().vertices[index];
  if (vertex.kind == VertexKind::infinity || vertex.milnor_number > 0 || vertex.half_branches() != 2)
    return std::nullopt;
  for (std::size_t arc = 0; arc < arcs_.arcs().size(); ++arc)
    for (std::size_t side = 0; side < 2; ++side)
      if (arcs_.arcs()[arc].ends[side] == index && !(arc == end.arc && side == end.end)) {
        end = {arc, 1 - side};
        return index;
      }
  return std::nullopt;
}

bool WholeCurve::is_end(const ArcEnd& end, const PointEnclosure& last, SurfaceResult& result) {
  const std::size_t index = arcs_.arcs()[end.arc].ends[end.end];
  const TopologyVertex& vertex = arcs_.topology().vertices[index];
  const VertexState& there = state(index, result);
  if (!there.at_infinity && !there.singular_point) return false;
  if (vertex.kind == VertexKind::infinity) {
    double reach = 0;
    for (const DoubleInterval& x : pair_.point(last.inverted, last.box)) reach = std::max(reach, x.magnitude());
    return reach > drawn_reach * limits_.size;
  }
  return is_near(end.arc, end.end, last, 1e-2);
}

bool WholeCurve::is_near(std::size_t arc, std::size_t end, const PointEnclosure& last, double tolerance) const {
  const std::size_t index = arcs_.arcs()[arc].ends[end];
  if (arcs_.topology().vertices[index].kind == VertexKind::infinity) return false;
  const auto at = arcs_.projection(last);
  const auto goal = arcs_.enclosure(index);
  for (std::size_t i = 0; i < 2; ++i)
    if (!(std::fabs(middle(at[i]) - middle(goal[i])) < tolerance * (1 + goal[i].magnitude()))) return false;
  return true;
}

std::optional<std::size_t> WholeCurve::seed_beyond(const ArcEnd& end, const PointEnclosure& last) {
  const auto at = arcs_.projection(last);
  const ProjectedArc& arc = arcs_.arcs()[end.arc];
  double parameter = middle(at[arc.vertical ? 1 : 0]);
  // Where the arc begins beyond a vertex.
  parameter = std::min(std::max(parameter, arc.inside.lower), arc.inside.upper);
  for (const double beyond : arcs_.parameters_beyond(end.arc, parameter, end.end)) {
    auto seed = arcs_.seed_above(pair_, end.arc, beyond, context_);
    if (!seed) continue;
    mark_unbounded(*seed);
    seeds_.push_back(*std::move(seed));
    visits_.push_back(1);
    return seeds_.size() - 1;
  }
  return std::nullopt;
}

std::optional<WholeCurve::KeptBox> WholeCurve::box_between(std::size_t arc, const PointEnclosure& from,
                                                           const PointEnclosure& to,
                                                           const std::optional<std::size_t>& vertex) const {
  auto at = arcs_.projection(from);
  if (vertex)
    for (std::size_t i = 0; i < 2; ++i) at[i] = hull(at[i], arcs_.enclosure(*vertex)[i]);
  const auto box = arcs_.box_between(arc, at, arcs_.projection(to), context_);
  if (!box) return std::nullopt;
  KeptBox result{{from.inverted[0], from.inverted[3]}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    result.box[i] = arcs_.from_chart(i, result.inverted[i]).inverse()((*box)[i]);
    if (!result.box[i].is_finite()) return std::nullopt;
  }
  return result;
}

std::optional<double> WholeCurve::gap_error(const KeptBox& below, const PointEnclosure& from,
                                            const PointEnclosure& to) const {
  const Charts charts{below.inverted[0], false, false, below.inverted[1]};
  std::optional<double> best;
  for (double side = 0x1p-6; side > 1e-9; side /= 8) {
    const auto boxes = fibre_boxes(pair_, charts, below.box[0], below.box[1], side, 1000);
    if (!boxes) break;
    const auto error = distance_within(*boxes, from, to);
    if (error && best && *error > 0.5 * *best) break;
    if (error) best = error;
  }
  return best;
}

std::optional<double> WholeCurve::distance_within(const std::vector<FibreBox>& boxes, const PointEnclosure& from,
                                                  const PointEnclosure& to) const {
  // v and s change continuously along the branch, so that it stays in boxes that touch.
  for (const auto& members : gather_boxes(boxes)) {
    const auto group = hull_of(boxes, members);
    if (!group) return std::nullopt;
    const auto holds = [&](const PointEnclosure& point) {
      const ParameterBox moved = in_charts(point.box, point.inverted, group->inverted);
      return overlap(moved[1], group->box[1]) && overlap(moved[2], group->box[2]);
    };
    if (!holds(from) || !holds(to)) continue;
    // Both surfaces hold the branch.
    double least = std::numeric_limits<double>::infinity();
    for (const SpaceBox& point :
         {pair_.point(group->inverted, group->box), pair_.second_point(group->inverted, group->box)}) {
      double square = 0;
      for (const DoubleInterval& x : point) square += width(x) * width(x);
      least = std::min(least, std::sqrt(square) * (1 + 1e-12));
    }
    if (std::isfinite(least)) return least;
  }
  return std::nullopt;
}

bool WholeCurve::stays_above(std::size_t index, std::size_t axis, const TracedBranch& traced,
                             std::size_t first_segment) const {
  const ProjectedArc& arc = arcs_.arcs()[index];
  for (std::size_t k = first_segment; k < traced.segments.size(); ++k) {
    const BranchTube& tube = traced.segments[k].tube;
    const DoubleInterval at = arcs_.from_chart(axis == 0 ? 0 : 1, tube.centre.inverted[axis])(tube.hull[axis]);
    // Finite points do not reach an end at infinity of two polynomial surfaces.
    const auto is_free = [&](std::size_t end) {
      return !traced.segments[k].crosses_infinity && are_polynomial() &&
             arcs_.topology().vertices[arc.ends[end]].kind == VertexKind::infinity;
    };
    if (!(arc.inside.lower < at.lower || is_free(0)) || !(at.upper < arc.inside.upper || is_free(1))) return false;
  }
  return true;
}

std::optional<WholeCurve::ArcEnd> WholeCurve::arc_end(const TracedBranch& traced, std::size_t seed,
                                                      bool forward) const {
  std::size_t last = seed;
  std::size_t first_segment = 0;
  if (!traced.passages.empty()) {
    last = traced.passages.back().seed;
    first_segment = traced.passages.back().segment;
    forward = traced.passages.back().forward;
  }
  // As long as its parameter stays between the ends of the arc the branch stays above it, and on its side of the seed.
  const BranchSeed& start = seeds_[last];
  if (stays_above(start.arc, start.axis, traced, first_segment)) {
    const bool increasing =
        forward == arcs_.from_chart(start.axis == 0 ? 0 : 1, start.point.inverted[start.axis]).is_increasing();
    return ArcEnd{start.arc, increasing ? std::size_t{1} : std::size_t{0}};
  }
  // It passed a vertex, but no seed since.
  for (std::size_t back = 1; back <= 8 && back + first_segment <= traced.segments.size(); ++back) {
    const std::size_t k = traced.segments.size() - back;
    const BranchSegment& segment = traced.segments[k];
    const DoubleInterval speed = segment.tube.velocity[0];
    if (!speed.excludes_zero()) continue;
    const auto arc = arcs_.arc_below(pair_, segment.end, context_);
    if (!arc || !stays_above(*arc, 0, traced, k + 1)) continue;
    const bool along = segment.tube.centre.at[segment.tube.axis] < middle(segment.end.box[segment.tube.axis]);
    const bool increasing =
        ((speed.lower > 0) == along) == arcs_.from_chart(0, segment.end.inverted[0]).is_increasing();
    return ArcEnd{*arc, increasing ? std::size_t{1} : std::size_t{0}};
  }
  return std::nullopt;
}

}  // namespace eliminant::intersect
