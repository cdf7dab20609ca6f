// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/surface_summary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

namespace eliminant::intersect {

namespace {

/// Parameters that are not known before all others.
std::array<double, 4> place_of(const SurfaceComponent& component) {
  std::array<double, 4> place = component.points.front().parameters;
  for (double& parameter : place)
    if (std::isnan(parameter)) parameter = -INFINITY;
  return place;
}

}  // namespace

void append(SurfaceResult& all, SurfaceResult part) {
  const std::size_t offset = all.singular_points.size();
  for (SurfaceComponent& component : part.components) {
    for (BranchEnd* end : {&component.start, &component.end})
      if (end->singular_point) *end->singular_point += offset;
    all.components.push_back(std::move(component));
  }
  std::move(part.singular_points.begin(), part.singular_points.end(), std::back_inserter(all.singular_points));
  for (std::string& warning : part.warnings)
    if (std::find(all.warnings.begin(), all.warnings.end(), warning) == all.warnings.end())
      all.warnings.push_back(std::move(warning));
  all.counts.excluded += part.counts.excluded;
  if (all.status == Status::infinite || part.status == Status::infinite) {
    const bool certified = all.rest_status.value_or(all.status) == Status::certified &&
                           part.rest_status.value_or(part.status) == Status::certified;
    all.rest_status = certified ? Status::certified : Status::numeric;
  }
  for (const Status status : {Status::incomplete, Status::infinite, Status::numeric})
    if (all.status == status || part.status == status) {
      all.status = status;
      break;
    }
  if (part.limit) all.limit = std::move(part.limit);
  if (all.engine.method.empty()) all.engine = std::move(part.engine);
}

void summarise(SurfaceResult& result) {
  std::stable_sort(result.components.begin(), result.components.end(), [](const auto& a, const auto& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    return place_of(a) < place_of(b);
  });
  const auto doubt = [&] {
    if (result.status == Status::certified) result.status = Status::numeric;
    if (result.rest_status == Status::certified) result.rest_status = Status::numeric;
  };
  const auto excluded = result.counts.excluded;
  result.counts = {};
  result.counts.excluded = excluded;
  for (const SurfaceComponent& component : result.components) {
    switch (component.kind) {
      case SurfaceComponentKind::curve:
        ++result.counts.curves;
        break;
      case SurfaceComponentKind::loop:
        ++result.counts.loops;
        break;
      case SurfaceComponentKind::point:
        ++result.counts.points;
        break;
      case SurfaceComponentKind::overlap:
        ++result.counts.overlaps;
        break;
    }
    if (!component.certified) doubt();
  }
  for (const SurfaceSingularPoint& point : result.singular_points)
    if (!point.certified) doubt();
  result.counts.singular = result.singular_points.size();
}

}  // namespace eliminant::intersect
