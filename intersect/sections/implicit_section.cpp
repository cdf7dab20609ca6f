// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/implicit_section.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/patches/branch_joining.hpp>
#include <eliminant/intersect/patches/surface_summary.hpp>
#include <eliminant/intersect/sections/collapsed_points.hpp>
#include <eliminant/intersect/sections/section_charts.hpp>
#include <eliminant/intersect/sections/section_factors.hpp>
#include <eliminant/intersect/whole_surfaces/projective_charts.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::ParametricSurface;
using symbolic::Polynomial;

/// Singular points that were found on several patches become one.
void merge_singular_points(SurfaceResult& result) {
  std::vector<SurfaceSingularPoint> merged;
  std::vector<std::size_t> index;
  for (SurfaceSingularPoint& point : result.singular_points) {
    const auto same =
        std::find_if(merged.begin(), merged.end(), [&](const auto& m) { return is_same_point(m.at, point.at); });
    index.push_back(static_cast<std::size_t>(same - merged.begin()));
    if (same == merged.end()) {
      merged.push_back(std::move(point));
    } else {
      same->certified = same->certified && point.certified;
      if (same->reason.empty()) same->reason = point.reason;
      for (std::size_t k = 0; k < 2; ++k)
        if (std::isnan(point.at.parameters[k])) same->at.parameters[k] = point.at.parameters[k];
    }
  }
  result.singular_points = std::move(merged);
  for (SurfaceComponent& component : result.components)
    for (BranchEnd* end : {&component.start, &component.end})
      if (end->singular_point) end->singular_point = index[*end->singular_point];
}

/// Points on their own that are another one's, or an end of a curve.
void remove_repeated_points(SurfaceResult& result) {
  std::vector<SurfaceComponent>& all = result.components;
  std::vector<bool> removed(all.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].kind != SurfaceComponentKind::point) continue;
    for (std::size_t j = 0; j < all.size() && !removed[i]; ++j) {
      if (i == j || removed[j] || (all[j].kind == SurfaceComponentKind::point && j > i)) continue;
      if (all[j].kind == SurfaceComponentKind::overlap) continue;
      removed[i] = is_same_point(all[j].points.front(), all[i].points.front()) ||
                   is_same_point(all[j].points.back(), all[i].points.front());
    }
  }
  std::size_t at = 0;
  std::erase_if(all, [&](const SurfaceComponent&) { return removed[at++]; });
}

}  // namespace

SurfaceResult intersect_surface_with_equation(const ParametricSurface& surface, const Polynomial& equation,
                                              const Options& options, const Context& context) {
  if (equation.is_constant())
    throw InvalidInput("the equation of a surface is constant", "a polynomial in x, y, z that is not constant");
  const auto start = std::chrono::steady_clock::now();
  SurfaceResult result;
  result.status = Status::certified;
  if (!surface.pieces.front().region && section_polynomial(surface.pieces.front().map, equation).is_zero()) {
    // All of a surface without borders.
    SurfaceComponent overlap;
    overlap.kind = SurfaceComponentKind::overlap;
    overlap.certified = options.certify;
    result.components.push_back(std::move(overlap));
    result.engine.method = "equation";
    summarise(result);
    result.status = Status::infinite;
    return result;
  }
  try {
    for (const SectionChart& part_of_surface : section_charts(surface)) {
      SurfaceResult part =
          intersect_patch_with_equation(part_of_surface.chart.piece, equation, part_of_surface.roles, options, context);
      to_surface_parameters(part, part_of_surface);
      append(result, std::move(part));
    }
  } catch (const LimitReached& limit) {
    result.status = Status::incomplete;
    result.limit = limit.what();
  }
  merge_singular_points(result);
  join_branches(result, domain_bounds(surface, ParametricSurface()));
  remove_repeated_points(result);
  join_at_collapsed_points(result, surface, equation);
  finish_collapsed_points(result);
  const Status status = result.status;
  summarise(result);
  if (status == Status::incomplete || status == Status::infinite) result.status = status;
  result.seconds.emplace_back("total", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return result;
}

void exchange_surfaces(SurfaceResult& result) {
  const auto exchange = [](auto& values) {
    std::swap(values[0], values[2]);
    std::swap(values[1], values[3]);
  };
  for (SurfaceComponent& component : result.components) {
    for (SurfacePoint& point : component.points) exchange(point.parameters);
    for (BranchEnd* end : {&component.start, &component.end}) {
      exchange(end->side);
      std::swap(end->third_side[0], end->third_side[1]);
    }
    std::swap(component.along_seam[0], component.along_seam[1]);
  }
  for (SurfaceSingularPoint& point : result.singular_points) exchange(point.at.parameters);
}

}  // namespace eliminant::intersect
