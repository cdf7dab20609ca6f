// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/one_point_borders.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/intersect/overlaps/patch_inversion.hpp>

namespace eliminant::intersect {

namespace {

/// A border that is one point, and the parameters of the nearest point of the other patch.
std::array<double, 4> parameters_of_point(const BalancedPair& pair, std::size_t axis, int side) {
  const std::size_t own = axis / 2;
  bridge::PatchJets patch(own == 0 ? pair.nets().first : pair.nets().second);
  bridge::PatchJets other(own == 0 ? pair.nets().second : pair.nets().first);
  std::array<double, 4> at{};
  at[axis] = side < 0 ? 0 : 1;
  const auto there = nearest_parameters(other, patch.at(at[2 * own], at[2 * own + 1]).point);
  at[2 - 2 * own] = there[0];
  at[3 - 2 * own] = there[1];
  return at;
}

}  // namespace

bridge::ContainedParts contained_point(const BalancedPair& pair, std::size_t axis, int side) {
  const std::array<double, 4> at = parameters_of_point(pair, axis, side);
  const auto a = bridge::PatchJets(pair.nets().first).at(at[0], at[1]);
  const auto b = bridge::PatchJets(pair.nets().second).at(at[2], at[3]);
  bridge::ContainedParts parts;
  parts.one_point = true;
  // Only said, not certified.
  constexpr double accuracy = 1e-12;
  if ((a.point - b.point).head<3>().abs().maxCoeff() <= a.error + b.error + accuracy * pair.size())
    parts.intervals.push_back({0, 1});
  return parts;
}

void end_at_point(std::vector<SurfaceComponent>& components, const BalancedPair& pair,
                  const bridge::ContainedBorder& border) {
  const std::array<double, 4> at = parameters_of_point(pair, border.axis, border.side);
  SurfacePoint point = pair.placed(at);
  const std::size_t along = border.axis < 2 ? 1 - border.axis : 5 - border.axis;
  bool reached = false;
  for (SurfaceComponent& component : components)
    for (BranchEnd* end : {&component.start, &component.end}) {
      const SurfacePoint& last = end == &component.start ? component.points.front() : component.points.back();
      const double distance =
          std::hypot(last.point[0] - point.point[0], last.point[1] - point.point[1], last.point[2] - point.point[2]);
      // About as large as the parts of the domain that are left open.
      constexpr double near = 1e-4;
      if (end->kind != BranchEndKind::unknown || !(distance < near * pair.size())) continue;
      point.parameters[along] = last.parameters[along];
      component.points.insert(end == &component.start ? component.points.begin() : component.points.end(), point);
      component.error = std::max(component.error, distance);
      component.certified = false;
      component.reason = "it comes near to a border that is one point; that it ends there is not proven";
      *end = BranchEnd{};
      end->side[border.axis] = border.side;
      reached = true;
    }
  if (reached) return;
  point.parameters[along] = std::nan("");
  SurfaceComponent component;
  component.kind = SurfaceComponentKind::point;
  component.points.push_back(point);
  component.start.side[border.axis] = border.side;
  component.end = component.start;
  component.tangential = true;
  component.error = pair.rounding_of(component);
  component.reason = "what else the surfaces have in common around a border that is one point is not proven";
  components.push_back(std::move(component));
}

}  // namespace eliminant::intersect
