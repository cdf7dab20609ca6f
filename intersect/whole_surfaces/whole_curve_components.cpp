// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/whole_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace eliminant::intersect {

namespace {

/// Of chords, relative to the distance from the origin, whatever finer is asked for: finer ones are too many.
constexpr double least_tolerance = 1e-6;

}  // namespace

SurfacePoint WholeCurve::presented(const PointEnclosure& point) const {
  SurfacePoint result;
  for (std::size_t i = 0; i < 4; ++i) {
    const double value = middle(point.box[i]);
    const double affine = !point.inverted[i] ? value : value == 0 ? std::numeric_limits<double>::infinity() : 1 / value;
    result.parameters[surfaces_.source[i]] = affine;
  }
  const SpaceBox place = pair_.point(point.inverted, point.box);
  for (std::size_t i = 0; i < 3; ++i) result.point[i] = middle(place[i]);
  return result;
}

SurfaceComponent WholeCurve::component(const Branch& branch, std::size_t first, std::size_t last, bool from_infinity,
                                       bool to_infinity) const {
  SurfaceComponent result;
  for (std::size_t k = first; k <= last; ++k) result.points.push_back(presented(branch.points[k]));
  const auto reach = [](const SurfacePoint& point) {
    return std::max({std::fabs(point.point[0]), std::fabs(point.point[1]), std::fabs(point.point[2])});
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (const SurfacePoint& point : result.points) nearest = std::min(nearest, reach(point));
  const auto is_far = [&](const SurfacePoint& point) {
    return !(reach(point) < drawn_reach * std::max(limits_.size, nearest));
  };
  std::size_t begin = 0;
  std::size_t end = result.points.size();
  while (from_infinity && begin + 1 < end && is_far(result.points[begin])) ++begin;
  while (to_infinity && begin + 1 < end && is_far(result.points[end - 1])) --end;
  result.points = {presented(branch.points[first + begin])};
  for (std::size_t k = begin; k + 1 < end; ++k)
    for (const ArcPoint& next : filled(branch, first + k)) {
      result.points.push_back(presented(next.point));
      result.error = std::max(result.error, next.error);
    }
  result.certified = true;
  return result;
}

double WholeCurve::tolerance_at(const PointEnclosure& point) const {
  double reach = limits_.size;
  for (const DoubleInterval& x : pair_.point(point.inverted, point.box))
    if (x.is_finite()) reach = std::max(reach, x.magnitude());
  return std::max(options_.tolerance, least_tolerance) * reach;
}

std::vector<ArcPoint> WholeCurve::filled(const Branch& branch, std::size_t chord) const {
  const auto& [error, crosses, tube] = branch.chords[chord];
  const PointEnclosure& next = branch.points[chord + 1];
  if (!tube) return {{next, error}};
  context_.checkpoint("drawing branches");
  const auto moved = [&charts = tube->centre.inverted](const PointEnclosure& point) {
    return PointEnclosure{charts, in_charts(point.box, point.inverted, charts)};
  };
  const PointEnclosure& from = branch.points[chord];
  std::vector<ArcPoint> result = fill_arc(pair_, *tube, moved(from), moved(next), tolerance_at(next));
  result.back().point = next;
  return result;
}

void WholeCurve::close_gap(SurfaceComponent& piece, const Branch& branch, std::size_t end, const BranchEnd& at,
                           const SurfaceResult& result) const {
  if (!at.singular_point) return;
  const SurfaceSingularPoint& point = result.singular_points[*at.singular_point];
  piece.points.insert(end == 0 ? piece.points.begin() : piece.points.end(), point.at);
  std::optional<double> error;
  if (branch.pinch_points[end]) {
    error = branch.pinch_errors[end];
  } else if (branch.ends[end]) {
    const std::size_t vertex = arcs_.arcs()[branch.ends[end]->arc].ends[branch.ends[end]->end];
    const FibreBox& box = *states_.at(vertex).lift.box;
    const PointEnclosure& last = end == 0 ? branch.points.front() : branch.points.back();
    const PointEnclosure goal{box.inverted, box.box};
    if (const auto below = box_between(branch.ends[end]->arc, last, goal)) error = gap_error(*below, last, goal);
  }
  if (error)
    piece.error = std::max(piece.error, *error);
  else if (piece.reason.empty())
    piece.reason = "how far the polyline is from the curve is not proven near a singular point";
}

bool WholeCurve::weight_changes_sign(const PointEnclosure& from, const PointEnclosure& to) const {
  const ParameterBox moved = in_charts(to.box, to.inverted, from.inverted);
  return std::any_of(weights_.begin(), weights_.end(), [&](const WeightFactor& factor) {
    return middle(factor.jet(from.inverted, from.box).value) * middle(factor.jet(from.inverted, moved).value) < 0;
  });
}

void WholeCurve::add_components(const Branch& branch, SurfaceResult& result) {
  std::vector<std::size_t> cuts;
  for (std::size_t k = 0; k < branch.chords.size(); ++k)
    if (branch.chords[k].crosses_infinity) cuts.push_back(k);
  const std::size_t last = branch.points.size() - 1;
  BranchEnd at_infinity;
  at_infinity.kind = BranchEndKind::infinity;
  if (branch.closed && cuts.empty()) {
    SurfaceComponent loop = component(branch, 0, last, false, false);
    loop.kind = SurfaceComponentKind::loop;
    loop.reason = branch.reason;
    loop.mirrored = branch.mirrored;
    loop.certified = branch.reason.empty();
    if (!branch.reason.empty()) doubt(result, branch.reason);
    result.components.push_back(std::move(loop));
    return;
  }
  Branch open = branch;
  if (branch.closed) {
    // Begin behind the first passage through infinity.
    const std::size_t shift = cuts.front() + 1;
    open.points.pop_back();
    std::rotate(open.points.begin(), open.points.begin() + static_cast<long>(shift), open.points.end());
    std::rotate(open.chords.begin(), open.chords.begin() + static_cast<long>(shift), open.chords.end());
    open.chords.pop_back();
  }
  std::size_t first = 0;
  std::string reason = branch.reason;
  if (!reason.empty()) doubt(result, reason);
  BranchEnd start = branch.closed ? at_infinity : branch_end(branch, 0, result, reason);
  for (std::size_t k = 0; k < open.points.size(); ++k) {
    const bool is_last = k + 1 == open.points.size();
    if (!is_last && !open.chords[k].crosses_infinity) continue;
    const BranchEnd end = is_last && !branch.closed ? branch_end(branch, 1, result, reason) : at_infinity;
    SurfaceComponent piece =
        component(open, first, k, start.kind == BranchEndKind::infinity, end.kind == BranchEndKind::infinity);
    piece.start = start;
    piece.end = end;
    piece.mirrored = branch.mirrored;
    piece.reason = reason;
    if (first == 0) close_gap(piece, branch, 0, start, result);
    if (is_last) close_gap(piece, branch, 1, end, result);
    if (!std::isfinite(piece.error) && piece.reason.empty())
      piece.reason = "the distance of the polyline from the curve has no bound";
    piece.certified = piece.reason.empty();
    if (!piece.certified) doubt(result, piece.reason);
    result.components.push_back(std::move(piece));
    start = at_infinity;
    first = k + 1;
    reason = branch.reason;
  }
}

}  // namespace eliminant::intersect
