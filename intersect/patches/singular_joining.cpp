// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/singular_joining.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace eliminant::intersect {

namespace {

bool is_contact(const SurfaceSingularPoint& point) {
  return point.kind == SurfaceSingularity::contact || point.kind == SurfaceSingularity::crossing;
}

/// Boxes around parameters, in which something is undecided.
bool touch(const SurfaceSingularPoint& a, const SurfaceSingularPoint& b) {
  constexpr double rounding = 1e-9;
  for (std::size_t k = 0; k < 4; ++k)
    if (!(std::fabs(a.at.parameters[k] - b.at.parameters[k]) <= (1 + rounding) * (a.radius + b.radius))) return false;
  return true;
}

bool are_one(const SurfaceSingularPoint& a, const SurfaceSingularPoint& b, const ParameterMetric& metric) {
  if (a.certified && b.certified)
    return is_contact(a) && is_contact(b) && metric.distance(a.at.parameters, b.at.parameters) < metric.same();
  return a.kind == SurfaceSingularity::undecided && b.kind == SurfaceSingularity::undecided && touch(a, b);
}

/// The hull of both boxes, or what is said of one contact on two pieces.
void absorb(SurfaceSingularPoint& point, const SurfaceSingularPoint& other) {
  if (is_contact(point)) {
    if (other.kind == SurfaceSingularity::crossing) point.kind = SurfaceSingularity::crossing;
    point.radius = std::max(point.radius, other.radius);
    return;
  }
  double reach = 0;
  for (std::size_t k = 0; k < 4; ++k)
    reach = std::max(reach, std::fabs(other.at.parameters[k] - point.at.parameters[k]));
  point.radius = std::max(point.radius, reach + other.radius);
}

}  // namespace

void join_singular_points(SurfaceResult& result, const DomainBounds& bounds) {
  const ParameterMetric metric(bounds);
  std::vector<SurfaceSingularPoint>& all = result.singular_points;
  std::vector<std::size_t> kept_as(all.size());
  std::vector<SurfaceSingularPoint> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto known =
        std::find_if(kept.begin(), kept.end(), [&](const auto& other) { return are_one(other, all[i], metric); });
    kept_as[i] = static_cast<std::size_t>(known - kept.begin());
    if (known == kept.end())
      kept.push_back(all[i]);
    else
      absorb(*known, all[i]);
  }
  const bool joined = kept.size() < all.size();
  std::vector<std::size_t> ends(kept.size(), 0);
  for (SurfaceComponent& component : result.components)
    for (BranchEnd* end : {&component.start, &component.end})
      if (end->singular_point) ++ends[*end->singular_point = kept_as[*end->singular_point]];
  if (joined) all = std::move(kept);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_contact(all[i]) || ends[i] == 0) continue;
    all[i].kind = SurfaceSingularity::crossing;
    all[i].half_branches = ends[i];
  }
}

}  // namespace eliminant::intersect
