// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/collapsed_points.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/intersect/patches/space_polyline.hpp>
#include <eliminant/intersect/sections/germ_in_space.hpp>
#include <eliminant/symbolic/elimination/rational_inversion.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;

constexpr double same_within = 1e-9;
/// Equations of surfaces of higher degree are not looked for.
constexpr unsigned long largest_equation_degree = 8;

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

/// The point of the segment at this part of its length.
std::array<double, 3> on_segment(const std::array<double, 3>& from, const std::array<double, 3>& to, double part) {
  std::array<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = from[k] + part * (to[k] - from[k]);
  return result;
}

double largest_coordinate(const std::array<double, 3>& p) {
  return std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
}

/// Whether two ends in the point around which the germ is are the two half-branches of one smooth arc: in a cube around
/// it the intersection is part of a graph, and both chords to the next points leave the cube on two sides of it.
bool go_on(const SurfaceResult& result, const CurveEnd& a, const CurveEnd& b, const SurfaceSingularPoint& point,
           GermInSpace& germ) {
  const double error =
      point.radius + std::max(result.components[a.component].error, result.components[b.component].error);
  constexpr double least_share = 1e-6;
  for (double part = 1; part > least_share; part /= 4) {
    const std::array<double, 3> to_a = germ.to_frame(on_segment(point.at.point, point_of(result, a, 1).point, part));
    const std::array<double, 3> to_b = germ.to_frame(on_segment(point.at.point, point_of(result, b, 1).point, part));
    const double size = std::max(largest_coordinate(to_a), largest_coordinate(to_b));
    if (!(size > 4 * error)) return false;
    const auto coordinate = germ.graph_coordinate(2 * size + error);
    if (!coordinate) continue;
    const double on_a = to_a[*coordinate];
    const double on_b = to_b[*coordinate];
    if (std::min(std::fabs(on_a), std::fabs(on_b)) > error) return (on_a > 0) != (on_b > 0);
  }
  return false;
}

/// The one other end that goes on where this one ends.
std::optional<std::size_t> partner(const SurfaceResult& result, const std::vector<CurveEnd>& ends, std::size_t own,
                                   const SurfaceSingularPoint& point, GermInSpace& germ) {
  const std::array<double, 4>& at = point_of(result, ends[own]).parameters;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::array<double, 4>& there = point_of(result, ends[i]).parameters;
    if (i == own || !is_same_parameter(at[0], there[0]) || !is_same_parameter(at[1], there[1])) continue;
    if (found) return std::nullopt;
    found = i;
  }
  if (found && !go_on(result, ends[own], ends[*found], point, germ)) return std::nullopt;
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
bool join_all(SurfaceResult& result, std::size_t singular_point, GermInSpace& germ) {
  const SurfaceSingularPoint& point = result.singular_points[singular_point];
  const std::vector<CurveEnd> ends = ends_in(result, singular_point);
  std::vector<std::pair<CurveEnd, CurveEnd>> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (end_of(result, ends[i]).kind == BranchEndKind::border) return false;
    const auto other = partner(result, ends, i, point, germ);
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

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The polyline from the end to the first point that is as far from it, or to the last one.
std::vector<std::array<double, 3>> stretch(const SurfaceResult& result, const CurveEnd& end, double length) {
  std::vector<std::array<double, 3>> points;
  for (std::size_t i = 0; i < result.components[end.component].points.size(); ++i) {
    points.push_back(point_of(result, end, i).point);
    if (distance(points.front(), points.back()) >= length) break;
  }
  return points;
}

double reach(const SurfaceResult& result, const CurveEnd& end) {
  double farthest = 0;
  for (const SurfacePoint& point : result.components[end.component].points)
    farthest = std::max(farthest, distance(point_of(result, end).point, point.point));
  return farthest;
}

/// Whether two ends in one point are known to belong to different half-branches in space: where one is half as far as
/// both lead, it is farther from the other than both errors.
bool are_apart(const SurfaceResult& result, const CurveEnd& a, const CurveEnd& b) {
  const double length = std::min(reach(result, a), reach(result, b));
  const std::array<double, 3> at = stretch(result, a, length / 2).back();
  const std::vector<std::array<double, 3>> other = stretch(result, b, length);
  double nearest = INFINITY;
  for (std::size_t i = 0; i + 1 < other.size(); ++i)
    nearest = std::min(nearest, distance_from_segment(other[i], other[i + 1], at));
  return nearest > result.components[a.component].error + result.components[b.component].error;
}

/// Half-branches in space that are known to be different: a map that covers its image twice shows each with two pairs
/// of parameters.
std::size_t different_half_branches(SurfaceResult& result, std::size_t singular_point) {
  std::vector<CurveEnd> different;
  for (const CurveEnd& end : ends_in(result, singular_point))
    if (std::all_of(different.begin(), different.end(),
                    [&](const CurveEnd& other) { return are_apart(result, end, other); }))
      different.push_back(end);
  return different.size();
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
  const std::optional<Polynomial> own = symbolic::low_equation(surface.pieces.front().map, largest_equation_degree);
  if (!own) return;
  const std::array<Polynomial, 4> affine{Polynomial::variable(3, 0), Polynomial::variable(3, 1),
                                         Polynomial::variable(3, 2), Polynomial::constant(3, 1)};
  const Polynomial own_equation = own->compose(affine);
  std::vector<bool> passed(result.singular_points.size(), false);
  for (const std::size_t i : collapsed) {
    SurfaceSingularPoint& point = result.singular_points[i];
    GermInSpace germ(own_equation, equation, point.at.point, point.radius);
    passed[i] = join_all(result, i, germ);
    if (!passed[i] && germ.is_singular()) point.kind = SurfaceSingularity::cusp;
  }
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
    // Curves end there, at a base point where they are not known to.
    if (ends[i] == 0 && !point.certified) continue;
    point.half_branches = ends[i];
    const std::size_t different = different_half_branches(result, i);
    if (different == 0) {
      point.kind = SurfaceSingularity::contact;
    } else if (different > 2) {
      point.kind = different == 4 ? SurfaceSingularity::crossing : SurfaceSingularity::cusp;
    } else if (point.kind == SurfaceSingularity::undecided) {
      point.certified = false;
      point.reason = "whether the curve is smooth where a line of parameters is one point is not proven";
    }
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
