// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/overlaps/overlap_borders.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace eliminant::intersect {

namespace {

/// Whether a point of a curve is on a polyline, as far as both are known: in space within both errors, and near it in
/// the parameters, which tell sheets of a surface apart.
class Outline {
 public:
  Outline(const SurfaceComponent& overlap, const DomainBounds& bounds) : overlap_(overlap) {
    for (std::size_t k = 0; k < 4; ++k) width_[k] = bounds[k] ? (*bounds[k])[1] - (*bounds[k])[0] : 1;
  }

  bool holds(const SurfacePoint& at, double error) const {
    constexpr double near = 1e-3;
    const double reach = error + overlap_.error;
    const auto& points = overlap_.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double place = foot(points[i].point, points[i + 1].point, at.point);
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k)
        square += std::pow(std::lerp(points[i].point[k], points[i + 1].point[k], place) - at.point[k], 2);
      if (!(square <= reach * reach)) continue;
      double apart = 0;
      for (std::size_t k = 0; k < 4; ++k)
        apart = std::max(apart, std::fabs(std::lerp(points[i].parameters[k], points[i + 1].parameters[k], place) -
                                          at.parameters[k]) /
                                    width_[k]);
      if (apart < near) return true;
    }
    return false;
  }

 private:
  using Point = std::array<double, 3>;

  static double foot(const Point& a, const Point& b, const Point& at) {
    double dot = 0;
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      dot += (at[k] - a[k]) * (b[k] - a[k]);
      square += (b[k] - a[k]) * (b[k] - a[k]);
    }
    return square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
  }

  const SurfaceComponent& overlap_;
  std::array<double, 4> width_{};
};

bool lies_on(const SurfaceComponent& component, const Outline& outline) {
  // Curves that leave the outline do so at an angle or at a corner.
  constexpr std::size_t samples = 16;
  const std::size_t last = component.points.size() - 1;
  for (std::size_t i = 0; i <= samples; ++i)
    if (!outline.holds(component.points[i * last / samples], component.error)) return false;
  return true;
}

}  // namespace

void remove_borders_of_overlaps(SurfaceResult& result, const DomainBounds& bounds) {
  std::vector<Outline> outlines;
  for (const SurfaceComponent& component : result.components)
    if (component.kind == SurfaceComponentKind::overlap && !component.points.empty())
      outlines.emplace_back(component, bounds);
  if (outlines.empty()) return;
  std::vector<bool> removed;
  for (const SurfaceComponent& component : result.components)
    removed.push_back(
        component.kind != SurfaceComponentKind::overlap &&
        std::any_of(outlines.begin(), outlines.end(), [&](const Outline& o) { return lies_on(component, o); }));
  std::size_t index = 0;
  std::erase_if(result.components, [&](const SurfaceComponent&) { return removed[index++]; });
}

}  // namespace eliminant::intersect
