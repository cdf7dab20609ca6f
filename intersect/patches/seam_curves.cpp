// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/seam_curves.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace eliminant::intersect {

namespace {

using Parameters = std::array<double, 4>;

/// Both are one curve, found from both sides of a seam.
bool repeats(const SurfaceComponent& a, const SurfaceComponent& b, const ParameterMetric& metric) {
  if (a.kind != SurfaceComponentKind::curve || b.kind != SurfaceComponentKind::curve) return false;
  const Parameters& first = b.points.front().parameters;
  const Parameters& last = b.points.back().parameters;
  const auto is_same = [&](const Parameters& from, const Parameters& to) {
    return metric.distance(a.points.front().parameters, from) < metric.same() &&
           metric.distance(a.points.back().parameters, to) < metric.same();
  };
  if (!is_same(first, last) && !is_same(last, first)) return false;
  // Two halves of a circle have the same ends.
  constexpr double near = 1e-4;
  if (!(distance_to(a, b.points[b.points.size() / 2].parameters, metric) < near)) return false;
  // Along one line of the parameters there is one curve from end to end.
  const KeptParameters of_a = kept_parameters(a);
  const KeptParameters of_b = kept_parameters(b);
  for (std::size_t k = 0; k < of_a.size(); ++k)
    if (of_a[k] && of_b[k]) return true;
  for (std::size_t i = 0; i < 2; ++i)
    if (a.along_seam[i] && b.along_seam[i]) return true;
  return false;
}

/// Whether a curve along a seam is found in parts on the other side of the seam, where branches end in it.
bool is_cut_by_others(const std::vector<SurfaceComponent>& all, std::size_t index, const ParameterMetric& metric) {
  if (all[index].kind != SurfaceComponentKind::curve) return false;
  const KeptParameters kept = kept_parameters(all[index]);
  for (std::size_t k = 0; k < 4; ++k) {
    if (!kept[k]) continue;
    const std::size_t along = k % 2 == 0 ? k + 1 : k - 1;
    const auto range = [&](const SurfaceComponent& component) {
      const auto [low, high] =
          std::minmax(component.points.front().parameters[along], component.points.back().parameters[along]);
      return std::array<double, 2>{low, high};
    };
    const auto [low, high] = range(all[index]);
    double rest = high - low;
    std::size_t parts = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i == index || all[i].kind != SurfaceComponentKind::curve || !kept_parameters(all[i])[k]) continue;
      const auto [from, to] = range(all[i]);
      const double apart = all[i].points.front().parameters[k] - all[index].points.front().parameters[k];
      const bool inside =
          std::fabs(apart) <= metric.same() && from >= low - metric.same() && to <= high + metric.same();
      // Polylines are that far from their curves in the parameters at most.
      constexpr double near = 1e-4;
      if (!inside || !(distance_to(all[index], all[i].points.front().parameters, metric) < near) ||
          !(distance_to(all[index], all[i].points.back().parameters, metric) < near))
        continue;
      rest -= to - from;
      ++parts;
    }
    if (parts > 1 && std::fabs(rest) <= 1e-7 * (high - low)) return true;
  }
  return false;
}

}  // namespace

KeptParameters kept_parameters(const SurfaceComponent& component) {
  KeptParameters kept{};
  constexpr double rounding = 1e-12;
  for (std::size_t i = 0; i < 2; ++i)
    kept[first_third_coordinate + i] =
        component.start.third_side[i] && component.end.third_side[i] &&
        std::all_of(component.points.begin(), component.points.end(), [&](const SurfacePoint& point) {
          return std::fabs(point.parameters[2 * i] + point.parameters[2 * i + 1] - 1) <= rounding;
        });
  for (std::size_t k = 0; k < 4; ++k)
    kept[k] = std::abs(component.start.side[k]) == 1 && component.start.side[k] == component.end.side[k] &&
              std::all_of(component.points.begin(), component.points.end(), [&](const SurfacePoint& point) {
                const double value = component.points.front().parameters[k];
                return std::fabs(point.parameters[k] - value) <= rounding * std::max(1.0, std::fabs(value));
              });
  return kept;
}

double distance_to(const SurfaceComponent& component, const std::array<double, 4>& at, const ParameterMetric& metric) {
  double result = INFINITY;
  const auto& points = component.points;
  if (points.size() == 1) return metric.distance(points.front().parameters, at);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Parameters& a = points[i].parameters;
    const Parameters& b = points[i + 1].parameters;
    double dot = 0;
    double square = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      dot += (at[k] - a[k]) * (b[k] - a[k]);
      square += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double place = square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
    Parameters foot;
    for (std::size_t k = 0; k < 4; ++k) foot[k] = a[k] + place * (b[k] - a[k]);
    result = std::min(result, metric.distance(foot, at));
  }
  return result;
}

void remove_repeated_seams(std::vector<SurfaceComponent>& components, const ParameterMetric& metric) {
  for (std::size_t i = 0; i < components.size(); ++i)
    for (std::size_t j = components.size(); j-- > i + 1;)
      if (repeats(components[i], components[j], metric))
        components.erase(components.begin() + static_cast<std::ptrdiff_t>(j));
  for (std::size_t i = components.size(); i-- > 0;)
    if (is_cut_by_others(components, i, metric)) components.erase(components.begin() + static_cast<std::ptrdiff_t>(i));
}

}  // namespace eliminant::intersect
