// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/whole_curve.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/intersect/whole_surfaces/pinch_arc.hpp>
#include <eliminant/intersect/whole_surfaces/pinch_enclosure.hpp>

namespace eliminant::intersect {

void WholeCurve::fold(std::vector<Branch>& branches, SurfaceResult& result) {
  const auto exchanged = [](const PointEnclosure& point) {
    return PointEnclosure{{point.inverted[2], point.inverted[3], point.inverted[0], point.inverted[1]},
                          {point.box[2], point.box[3], point.box[0], point.box[1]}};
  };
  const auto lies_on = [](const PointEnclosure& point, const Branch& branch) {
    return std::any_of(branch.chords.begin(), branch.chords.end(), [&](const Chord& chord) {
      return chord.tube && chord.tube->holds(in_charts(point.box, point.inverted, chord.tube->centre.inverted));
    });
  };
  const auto maps_to = [&](const Branch& from, const Branch& to) {
    const std::size_t stride = std::max<std::size_t>(1, from.points.size() / 64);
    for (std::size_t k = 0; k < from.points.size(); k += stride)
      if (lies_on(exchanged(from.points[k]), to)) return true;
    return false;
  };
  std::vector<Branch> kept;
  std::vector<bool> used(branches.size(), false);
  for (std::size_t k = 0; k < branches.size(); ++k) {
    if (used[k]) continue;
    bool found = false;
    for (std::size_t other = k; other < branches.size() && !found; ++other) {
      if (used[other] || !maps_to(branches[k], branches[other])) continue;
      found = used[other] = true;
      branches[k].mirrored = other == k;
    }
    if (!found) doubt(result, "the other preimages of a branch of double points were not found");
    if (branches[k].mirrored) halve(branches[k], result);
    kept.push_back(std::move(branches[k]));
  }
  branches = std::move(kept);
}

std::optional<std::array<DoubleInterval, 2>> WholeCurve::enclosed_pinch_point(const Gap& gap) const {
  // Both points are one: its parameters (u, v) are those of the projection. Where its derivative has rank two a
  // surface takes no point twice nearby.
  if (!gap.below) return std::nullopt;
  return enclose_pinch_point(surfaces_.first, gap.below->inverted, gap.below->box);
}

SurfaceSingularPoint WholeCurve::pinch_point(const Branch& branch, const Gap& gap) const {
  SurfaceSingularPoint result;
  result.kind = SurfaceSingularity::pinch_point;
  result.half_branches = 1;
  result.certified = branch.reason.empty();
  result.reason = branch.reason;
  if (const auto at = enclosed_pinch_point(gap)) {
    const auto& inverted = gap.below->inverted;
    const PointEnclosure point{{inverted[0], inverted[1], inverted[0], inverted[1]},
                               {(*at)[0], (*at)[1], (*at)[0], (*at)[1]}};
    result.at = presented(point);
    for (const DoubleInterval& side : point.box) result.radius = std::max(result.radius, width(side));
    for (const DoubleInterval& side : pair_.point(point.inverted, point.box))
      result.radius = std::max(result.radius, width(side));
    if (std::isfinite(result.radius)) return result;
  }
  const SurfacePoint before = presented(branch.points[gap.chord]);
  const SurfacePoint after = presented(branch.points[gap.chord + 1]);
  result.radius = branch.chords[gap.chord].error;
  for (std::size_t i = 0; i < 4; ++i) {
    // Of both points, exchanged.
    const double first = before.parameters[i] + after.parameters[i];
    const double second = before.parameters[(i + 2) % 4] + after.parameters[(i + 2) % 4];
    result.at.parameters[i] = (first + second) / 4;
    result.radius = std::max(result.radius, std::fabs(before.parameters[i] - after.parameters[i]));
  }
  for (std::size_t i = 0; i < 3; ++i) result.at.point[i] = (before.point[i] + after.point[i]) / 2;
  return result;
}

void WholeCurve::lead_to_pinch_point(Branch& branch, std::size_t end, const Gap& gap) const {
  const auto at = enclosed_pinch_point(gap);
  if (!at) return;
  const PointEnclosure& last = end == 0 ? branch.points.front() : branch.points.back();
  const auto arc = trace_pinch_arc(surfaces_.first, last, gap.below->inverted, *at, tolerance_at(last), context_);
  if (!arc) return;
  branch.pinch_errors[end] = arc->error;
  const std::vector<Chord> chords(arc->points.size(), Chord{arc->error, false, {}});
  if (end == 0) {
    branch.points.insert(branch.points.begin(), arc->points.rbegin(), arc->points.rend());
    branch.chords.insert(branch.chords.begin(), chords.begin(), chords.end());
  } else {
    branch.points.insert(branch.points.end(), arc->points.begin(), arc->points.end());
    branch.chords.insert(branch.chords.end(), chords.begin(), chords.end());
  }
}

void WholeCurve::halve(Branch& branch, SurfaceResult& result) {
  // The exchange of both points turns the branch round: its fixed points, at which these are one, are pinch points. No
  // tube contains such a point.
  std::vector<Gap> turning;
  for (const Gap& gap : branch.gaps) {
    bool turns = true;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      const auto difference = [&](const PointEnclosure& point) {
        const double a = middle(point.box[i]);
        const double b =
            middle(in_charts(point.box, point.inverted,
                             {point.inverted[0], point.inverted[1], point.inverted[0], point.inverted[1]})[i + 2]);
        return (b - a) * (point.inverted[i] ? -1 : 1);
      };
      const double before = difference(branch.points[gap.chord]);
      const double after = difference(branch.points[gap.chord + 1]);
      turns = turns && (before * after < 0 || std::max(std::fabs(before), std::fabs(after)) < 1e-9);
    }
    if (turns) turning.push_back(gap);
  }
  std::sort(turning.begin(), turning.end(), [](const Gap& a, const Gap& b) { return a.chord < b.chord; });
  if (turning.size() != (branch.closed ? 2U : 1U)) {
    branch.reason = "the pinch points of the branch were not found";
    doubt(result, branch.reason);
    return;
  }
  const auto end_at = [&](const Gap& gap, std::size_t end) {
    branch.pinch_points[end] = result.singular_points.size();
    branch.pinch_errors[end] = branch.chords[gap.chord].error;
    result.singular_points.push_back(pinch_point(branch, gap));
  };
  const std::size_t first = turning.front().chord;
  const std::size_t last = branch.closed ? turning.back().chord : branch.chords.size();
  end_at(turning.front(), 0);
  if (branch.closed) end_at(turning.back(), 1);
  const auto part = [&](auto& list, std::size_t from, std::size_t to) {
    list.erase(list.begin() + static_cast<long>(to), list.end());
    list.erase(list.begin(), list.begin() + static_cast<long>(from));
  };
  part(branch.points, first + 1, last + 1);
  part(branch.chords, first + 1, last);
  const bool both = branch.closed;
  branch.closed = false;
  lead_to_pinch_point(branch, 0, turning.front());
  if (both) lead_to_pinch_point(branch, 1, turning.back());
}

}  // namespace eliminant::intersect
