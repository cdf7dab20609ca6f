// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/collapsed_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/intersect/sections/space_form.hpp>
#include <eliminant/symbolic/elimination/rational_inversion.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;

constexpr double same_within = 1e-9;

bool is_same_parameter(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return true;
  const bool large = std::fabs(a) > 1 && std::fabs(b) > 1;
  return std::fabs(large ? 1 / a - 1 / b : a - b) < same_within;
}

/// An end of a curve.
struct CurveEnd {
  std::size_t component = 0;
  bool at_start = false;
};

BranchEnd& end_of(SurfaceResult& result, const CurveEnd& end) {
  SurfaceComponent& component = result.components[end.component];
  return end.at_start ? component.start : component.end;
}

/// The point of the polyline at the end, or the one next to it.
const SurfacePoint& point_of(const SurfaceResult& result, const CurveEnd& end, std::size_t index = 0) {
  const std::vector<SurfacePoint>& points = result.components[end.component].points;
  return end.at_start ? points[index] : points[points.size() - 1 - index];
}

std::vector<CurveEnd> ends_in(SurfaceResult& result, std::size_t singular_point) {
  std::vector<CurveEnd> ends;
  for (std::size_t c = 0; c < result.components.size(); ++c)
    for (const bool at_start : {true, false})
      if (end_of(result, {c, at_start}).singular_point == singular_point) ends.push_back({c, at_start});
  return ends;
}

/// Drops the marked ones, to which no end refers.
void remove_singular_points(SurfaceResult& result, const std::vector<bool>& removed) {
  std::vector<std::size_t> index;
  std::vector<SurfaceSingularPoint> kept;
  for (std::size_t i = 0; i < removed.size(); ++i) {
    index.push_back(kept.size());
    if (!removed[i]) kept.push_back(std::move(result.singular_points[i]));
  }
  result.singular_points = std::move(kept);
  for (SurfaceComponent& component : result.components)
    for (BranchEnd* end : {&component.start, &component.end})
      if (end->singular_point) end->singular_point = index[*end->singular_point];
}

/// Two surfaces by their equations.
class TransversalPair {
 public:
  TransversalPair(const Polynomial& first, const Polynomial& second) {
    for (std::size_t k = 0; k < 3; ++k) {
      gradients_[0].emplace_back(first.derivative(k));
      gradients_[1].emplace_back(second.derivative(k));
    }
  }

  /// The coordinate over which the intersection is a graph, with the least slopes, in a box around a point of it;
  /// nullopt where none is proven.
  std::optional<std::size_t> graph_coordinate(const std::array<double, 3>& point, double radius) const {
    std::array<DoubleInterval, 3> box;
    for (std::size_t k = 0; k < 3; ++k) box[k] = DoubleInterval::around(point[k], radius);
    std::array<std::array<DoubleInterval, 3>, 2> at;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 3; ++k) at[i][k] = gradients_[i][k].at(box).value;
    std::optional<std::size_t> best;
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3;
      const std::size_t b = (k + 2) % 3;
      const DoubleInterval minor = at[0][a] * at[1][b] - at[0][b] * at[1][a];
      const double least = std::max(minor.lower, -minor.upper);
      if (!(least > largest)) continue;
      largest = least;
      best = k;
    }
    return best;
  }

 private:
  std::array<std::vector<SpaceForm>, 2> gradients_;
};

/// Whether two ends are the two half-branches of one smooth arc.
bool go_on(const SurfaceResult& result, const CurveEnd& a, const CurveEnd& b, const SurfaceSingularPoint& point,
           const TransversalPair& surfaces) {
  const std::array<double, 3>& centre = point.at.point;
  const std::array<double, 3>& on_a = point_of(result, a, 1).point;
  const std::array<double, 3>& on_b = point_of(result, b, 1).point;
  double radius = 0;
  for (std::size_t k = 0; k < 3; ++k)
    radius = std::max({radius, std::fabs(on_a[k] - centre[k]), std::fabs(on_b[k] - centre[k])});
  const double error =
      point.radius + std::max(result.components[a.component].error, result.components[b.component].error);
  const auto coordinate = surfaces.graph_coordinate(centre, 2 * radius + error);
  if (!coordinate) return false;
  const double to_a = on_a[*coordinate] - centre[*coordinate];
  const double to_b = on_b[*coordinate] - centre[*coordinate];
  return std::min(std::fabs(to_a), std::fabs(to_b)) > error && (to_a > 0) != (to_b > 0);
}

/// The one other end that goes on where this one ends.
std::optional<std::size_t> partner(const SurfaceResult& result, const std::vector<CurveEnd>& ends, std::size_t own,
                                   const SurfaceSingularPoint& point, const TransversalPair& surfaces) {
  const std::array<double, 4>& at = point_of(result, ends[own]).parameters;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::array<double, 4>& there = point_of(result, ends[i]).parameters;
    if (i == own || !is_same_parameter(at[0], there[0]) || !is_same_parameter(at[1], there[1])) continue;
    if (found) return std::nullopt;
    found = i;
  }
  if (found && !go_on(result, ends[own], ends[*found], point, surfaces)) return std::nullopt;
  return found;
}

void reverse(SurfaceComponent& component) {
  std::reverse(component.points.begin(), component.points.end());
  std::swap(component.start, component.end);
}

/// The second one becomes empty; of two ends of one curve that is closed.
void join(SurfaceResult& result, const CurveEnd& a, const CurveEnd& b) {
  SurfaceComponent& first = result.components[a.component];
  if (a.component == b.component) {
    first.kind = SurfaceComponentKind::loop;
    first.points.back() = first.points.front();
    first.start = first.end = BranchEnd();
    return;
  }
  SurfaceComponent& second = result.components[b.component];
  if (a.at_start) reverse(first);
  if (!b.at_start) reverse(second);
  first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
  first.end = second.end;
  first.error = std::max(first.error, second.error);
  first.tangential = first.tangential || second.tangential;
  first.certified = first.certified && second.certified;
  if (first.reason.empty()) first.reason = second.reason;
  second = SurfaceComponent();
}

/// Joins what goes on in one point; false where not all ends have a partner.
bool join_all(SurfaceResult& result, std::size_t singular_point, const TransversalPair& surfaces) {
  const SurfaceSingularPoint& point = result.singular_points[singular_point];
  const std::vector<CurveEnd> ends = ends_in(result, singular_point);
  std::vector<std::pair<CurveEnd, CurveEnd>> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (end_of(result, ends[i]).kind == BranchEndKind::border) return false;
    const auto other = partner(result, ends, i, point, surfaces);
    if (!other) return false;
    if (i < *other) pairs.emplace_back(ends[i], ends[*other]);
  }
  // Turning a curve round moves its other end, so that ends are looked up by where they are joined to.
  while (!pairs.empty()) {
    const auto [a, b] = pairs.back();
    pairs.pop_back();
    join(result, a, b);
    if (a.component == b.component) continue;
    for (auto& [c, d] : pairs)
      for (CurveEnd* end : {&c, &d}) {
        if (end->component == b.component)
          *end = {a.component, false};
        else if (end->component == a.component)
          end->at_start = true;
      }
  }
  return !ends.empty();
}

}  // namespace

bool has_unknown_parameters(const SurfacePoint& point) {
  return std::isnan(point.parameters[0]) || std::isnan(point.parameters[1]);
}

bool is_same_point(const SurfacePoint& a, const SurfacePoint& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::fabs(a.point[k] - b.point[k]) <= same_within * std::max(1.0, std::fabs(a.point[k])))) return false;
  // Curves of parameters that are mapped to one point: the lines at infinity of a sphere from its pole.
  if (has_unknown_parameters(a) && has_unknown_parameters(b)) return true;
  // One point in space may have several pairs of parameters.
  return is_same_parameter(a.parameters[0], b.parameters[0]) && is_same_parameter(a.parameters[1], b.parameters[1]);
}

void join_at_collapsed_points(SurfaceResult& result, const symbolic::ParametricSurface& surface,
                              const Polynomial& equation) {
  std::vector<std::size_t> collapsed;
  for (std::size_t i = 0; i < result.singular_points.size(); ++i)
    if (has_unknown_parameters(result.singular_points[i].at) && !ends_in(result, i).empty()) collapsed.push_back(i);
  if (collapsed.empty() || surface.pieces.size() != 1 ||
      surface.pieces.front().map.kind() != symbolic::RationalSurface::Kind::tensor_product)
    return;
  const std::optional<Polynomial> own = symbolic::low_equation(surface.pieces.front().map);
  if (!own) return;
  const std::array<Polynomial, 4> affine{Polynomial::variable(3, 0), Polynomial::variable(3, 1),
                                         Polynomial::variable(3, 2), Polynomial::constant(3, 1)};
  const TransversalPair surfaces(own->compose(affine), equation);
  std::vector<bool> passed(result.singular_points.size(), false);
  for (const std::size_t i : collapsed) passed[i] = join_all(result, i, surfaces);
  std::erase_if(result.components, [](const SurfaceComponent& component) { return component.points.empty(); });
  remove_singular_points(result, passed);
}

void finish_collapsed_points(SurfaceResult& result) {
  std::vector<std::size_t> ends(result.singular_points.size(), 0);
  std::vector<bool> needed(result.singular_points.size(), false);
  for (SurfaceComponent& component : result.components)
    for (BranchEnd* end : {&component.start, &component.end}) {
      if (!end->singular_point) continue;
      ++ends[*end->singular_point];
      if (end->kind == BranchEndKind::border)
        end->singular_point.reset();
      else
        needed[*end->singular_point] = true;
    }
  std::vector<SurfaceSingularPoint> kept;
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    SurfaceSingularPoint& point = result.singular_points[i];
    index.push_back(kept.size());
    if (!has_unknown_parameters(point.at)) {
      kept.push_back(std::move(point));
      continue;
    }
    if (ends[i] > 0 && !needed[i]) continue;
    point.half_branches = ends[i];
    point.kind = ends[i] == 0   ? SurfaceSingularity::contact
                 : ends[i] == 4 ? SurfaceSingularity::crossing
                                : SurfaceSingularity::cusp;
    if (ends[i] == 0) {
      SurfaceComponent component;
      component.kind = SurfaceComponentKind::point;
      component.points.push_back(point.at);
      component.error = point.radius;
      component.certified = point.certified;
      result.components.push_back(std::move(component));
    }
    kept.push_back(std::move(point));
  }
  result.singular_points = std::move(kept);
  for (SurfaceComponent& component : result.components)
    for (BranchEnd* end : {&component.start, &component.end})
      if (end->singular_point) end->singular_point = index[*end->singular_point];
}

}  // namespace eliminant::intersect
