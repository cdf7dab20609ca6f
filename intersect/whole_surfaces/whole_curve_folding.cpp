// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/whole_curve.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::intersect {

void WholeCurve::fold(std::vector<Branch>& branches, SurfaceResult& result) {
  const auto exchanged = [](const PointEnclosure& point) {
    return PointEnclosure{{point.inverted[2], point.inverted[3], point.inverted[0], point.inverted[1]},
                          {point.box[2], point.box[3], point.box[0], point.box[1]}};
  };
  const auto lies_on = [](const PointEnclosure& point, const Branch& branch) {
    return std::any_of(branch.tubes.begin(), branch.tubes.end(), [&](const BranchTube& tube) {
      return tube.holds(in_charts(point.box, point.inverted, tube.centre.inverted));
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

void WholeCurve::halve(Branch& branch, SurfaceResult& result) {
  // The exchange of both points turns the branch round: its fixed points, at which these are one, are pinch points. No
  // tube contains such a point.
  std::vector<std::size_t> turning;
  for (const std::size_t gap : branch.gaps) {
    bool turns = true;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      const auto difference = [&](const PointEnclosure& point) {
        const double a = middle(point.box[i]);
        const double b =
            middle(in_charts(point.box, point.inverted,
                             {point.inverted[0], point.inverted[1], point.inverted[0], point.inverted[1]})[i + 2]);
        return (b - a) * (point.inverted[i] ? -1 : 1);
      };
      const double before = difference(branch.points[gap]);
      const double after = difference(branch.points[gap + 1]);
      turns = turns && (before * after < 0 || std::max(std::fabs(before), std::fabs(after)) < 1e-9);
    }
    if (turns) turning.push_back(gap);
  }
  std::sort(turning.begin(), turning.end());
  if (turning.size() != (branch.closed ? 2U : 1U)) {
    branch.reason = "the pinch points of the branch were not found";
    doubt(result, branch.reason);
    return;
  }
  const auto pinch_point = [&](std::size_t gap) {
    SurfaceSingularPoint point;
    const SurfacePoint before = presented(branch.points[gap]);
    const SurfacePoint after = presented(branch.points[gap + 1]);
    for (std::size_t i = 0; i < 4; ++i) {
      // Of both points, exchanged.
      const double first = before.parameters[i] + after.parameters[i];
      const double second = before.parameters[(i + 2) % 4] + after.parameters[(i + 2) % 4];
      point.at.parameters[i] = (first + second) / 4;
    }
    for (std::size_t i = 0; i < 3; ++i) point.at.point[i] = (before.point[i] + after.point[i]) / 2;
    for (std::size_t i = 0; i < 4; ++i)
      point.radius = std::max(point.radius, std::fabs(before.parameters[i] - after.parameters[i]));
    point.radius = std::max(point.radius, branch.errors[gap]);
    point.kind = SurfaceSingularity::pinch_point;
    point.half_branches = 1;
    point.certified = branch.reason.empty();
    point.reason = branch.reason;
    result.singular_points.push_back(point);
    return result.singular_points.size() - 1;
  };
  const std::size_t first = turning.front();
  const std::size_t last = branch.closed ? turning.back() : branch.errors.size();
  branch.pinch_points[0] = pinch_point(first);
  if (branch.closed) branch.pinch_points[1] = pinch_point(last);
  const auto part = [&](auto& list, std::size_t from, std::size_t to) {
    list.erase(list.begin() + static_cast<long>(to), list.end());
    list.erase(list.begin(), list.begin() + static_cast<long>(from));
  };
  part(branch.points, first + 1, last + 1);
  part(branch.errors, first + 1, last);
  part(branch.crosses, first + 1, last);
  branch.closed = false;
}

}  // namespace eliminant::intersect
