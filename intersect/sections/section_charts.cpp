// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/section_charts.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

#include <eliminant/symbolic/elimination/blown_up_base_point.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::ParametricSurface;
using symbolic::SurfacePiece;

SideRoles roles_of(const ProjectiveChart& chart, const ParametricSurface& surface) {
  SideRoles roles{};
  // Each line inside a triangle is a side u = 1 of one part and a side v = 1 of another.
  if (chart.corner) return {{{SideRole::border, SideRole::seam}, {SideRole::border, SideRole::other_seam}}};
  const bool whole = !surface.pieces.front().region;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t side = 0; side < 2; ++side) {
      SideRole& role = roles[k][side];
      if (whole) {
        role = chart.inverted[k] ? SideRole::other_seam : SideRole::seam;
        continue;
      }
      const symbolic::Interval& own = chart.piece.region->sides[k];
      // Another piece goes on beyond this side.
      const bool goes_on = std::any_of(surface.pieces.begin(), surface.pieces.end(), [&](const SurfacePiece& other) {
        const symbolic::Interval& there = other.region->sides[k];
        return side == 0 ? there.lower < own.lower : own.upper < there.upper;
      });
      if (goes_on) role = side == 0 ? SideRole::seam : SideRole::other_seam;
    }
  return roles;
}

/// Both charts around the base point at both infinite parameters, of a chart of a surface without domains; none where
/// it has no such point.
std::vector<SectionChart> blown_up(const SectionChart& whole) {
  const ProjectiveChart& chart = whole.chart;
  if (!chart.inverted[0] || !chart.inverted[1]) return {};
  const auto maps = symbolic::blown_up_at_origin(chart.piece.map);
  if (!maps) return {};
  std::vector<SectionChart> result;
  for (const std::size_t kept : {0U, 1U}) {
    SectionChart part = whole;
    // The quotient of both parameters and its inverse run from -1 to 1, as the parameters do.
    part.chart.piece.map = (*maps)[kept];
    part.kept = kept;
    const SideRole role = kept == 0 ? SideRole::seam : SideRole::other_seam;
    part.roles[1 - kept] = {role, role};
    result.push_back(std::move(part));
  }
  return result;
}

}  // namespace

std::vector<SectionChart> section_charts(const ParametricSurface& surface) {
  constexpr std::size_t of_its_own = 2;
  std::vector<SectionChart> result;
  for (ProjectiveChart& chart : projective_charts(surface, of_its_own)) {
    const SideRoles roles = roles_of(chart, surface);
    SectionChart whole{std::move(chart), std::nullopt, roles};
    std::vector<SectionChart> parts = blown_up(whole);
    if (parts.empty()) parts.push_back(std::move(whole));
    std::move(parts.begin(), parts.end(), std::back_inserter(result));
  }
  return result;
}

void to_surface_parameters(SurfaceResult& result, const SectionChart& chart) {
  if (chart.kept) {
    const auto blow_down = [&](SurfacePoint& point) {
      point.parameters[1 - *chart.kept] *= point.parameters[*chart.kept];
    };
    for (SurfaceComponent& component : result.components)
      for (SurfacePoint& point : component.points) blow_down(point);
    for (SurfaceSingularPoint& point : result.singular_points) blow_down(point.at);
  }
  to_surface_parameters(result, chart.chart, chart.chart);
}

}  // namespace eliminant::intersect
