// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/triangle_charts.hpp>

#include <algorithm>
#include <utility>

#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;
using symbolic::Rational;

using Barycentric = std::array<Rational, 3>;

/// In 17ths, the point inside. Small numbers keep rational points simple, and few lines of simple equations meet it.
using Inside = std::array<long, 3>;
constexpr long parts_of_one = 17;
constexpr std::array<Inside, 3> inside_points{{{4, 6, 7}, {7, 4, 6}, {6, 7, 4}}};

Barycentric corner_point(std::size_t corner) {
  Barycentric point;
  point[corner] = Rational(1);
  return point;
}

/// Sides are halved, so that triangles with a side in common have its parts in common, too.
Barycentric middle(std::size_t from, std::size_t to) {
  Barycentric point;
  point[from] = point[to] = Rational(1) / Rational(2);
  return point;
}

Rational determinant(const Barycentric& a, const Barycentric& b, const Barycentric& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Barycentric scaled(const Barycentric& point, const Rational& factor) {
  return {factor * point[0], factor * point[1], factor * point[2]};
}

/// The images of (0, 0), (1, 0), (1, 1) and (0, 1), scaled so that the first plus the third is the second plus the
/// fourth: then the bilinear map between them is linear. The factors are positive where the quadrilateral is convex.
std::array<Barycentric, 4> quadrilateral(std::size_t corner, const Inside& inside) {
  const Barycentric p0 = corner_point(corner);
  const Barycentric p1 = middle(corner, (corner + 1) % 3);
  Barycentric p2;
  for (std::size_t k = 0; k < 3; ++k) p2[k] = Rational(inside[k]) / Rational(parts_of_one);
  const Barycentric p3 = middle(corner, (corner + 2) % 3);
  const Rational whole = determinant(p0, p1, p3);
  return {scaled(p0, Rational(0) - determinant(p2, p1, p3) / whole), scaled(p1, determinant(p0, p2, p3) / whole), p2,
          scaled(p3, determinant(p0, p1, p2) / whole)};
}

/// The linear form with these values of coordinate k at (0, 0), (1, 0) and (0, 1).
Polynomial linear(const std::array<Barycentric, 4>& places, std::size_t k) {
  const Rational& origin = places[0][k];
  const std::vector<Polynomial::Term> terms{
      {origin, {0, 0}}, {places[1][k] - origin, {1, 0}}, {places[3][k] - origin, {0, 1}}};
  return Polynomial::from_terms(2, terms);
}

}  // namespace

std::array<double, 2> TriangleCorner::at(double a, double b) const {
  std::array<double, 3> sum{};
  // What is zero on a side stays exactly zero there.
  for (std::size_t k = 0; k < 3; ++k)
    sum[k] = (1 - a) * (1 - b) * places[0][k] + a * (1 - b) * places[1][k] + a * b * places[2][k] +
             (1 - a) * b * places[3][k];
  const double weight = sum[0] + sum[1] + sum[2];
  return {sum[0] / weight, sum[1] / weight};
}

bool TriangleCorner::follows_border(std::size_t axis) const {
  // The other parameter leads to the corner before, or after. Borders are followed by v where u = 0, by u where v = 0,
  // by v where u + v = 1.
  const std::size_t to = (corner + (axis == 0 ? 2 : 1)) % 3;
  const std::size_t zero = border(axis);
  return zero == 1 ? to == 0 : to == 1;
}

std::vector<TriangleChart> triangle_charts(const symbolic::SurfacePiece& triangle, std::size_t which) {
  std::vector<TriangleChart> charts;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const std::array<Barycentric, 4> places = quadrilateral(corner, inside_points[which]);
    const std::array<Polynomial, 3> images{linear(places, 0), linear(places, 1), linear(places, 2)};
    std::vector<Polynomial> coordinates;
    for (const Polynomial& form : triangle.map.coordinates()) coordinates.push_back(form.compose(images));
    TriangleCorner place{corner, {}};
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) place.places[i][k] = bridge::nearest(places[i][k]);
    const symbolic::Interval unit{0, 1};
    charts.push_back(
        {{symbolic::RationalSurface(symbolic::RationalSurface::Kind::tensor_product, std::move(coordinates)),
          symbolic::ParameterRegion{{unit, unit}, false}},
         place});
  }
  return charts;
}

namespace {

/// `at` is the point in the parameters of the quadrilateral.
BranchEnd end_in_triangle(const BranchEnd& end, const SurfacePoint& at, const TriangleCorner& corner,
                          std::size_t index) {
  BranchEnd result = end;
  const std::size_t first = 2 * index;
  result.side[first] = result.side[first + 1] = 0;
  const auto is_border = [&](std::size_t axis) {
    return end.side[first + axis] < 0 && at.parameters[first + axis] == 0;
  };
  bool on_seam = false;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    on_seam = on_seam || (end.side[first + axis] != 0 && !is_border(axis));
    if (!is_border(axis)) continue;
    if (corner.border(axis) == 2)
      result.third_side[index] = true;
    else
      result.side[first + corner.border(axis)] = -1;
  }
  // The mark of a seam is a side on which the triangle has no border.
  if (on_seam) result.side[result.side[first] == 0 ? first : first + 1] = seam_in_triangle;
  const auto leading = static_cast<std::size_t>(
      std::find_if(end.side.begin(), end.side.end(), [](int side) { return side != 0; }) - end.side.begin());
  if (leading != first && leading != first + 1) return result;
  if (on_seam || (end.side[first] != 0 && end.side[first + 1] != 0))
    result.transition = Transition::touching;
  else if (!corner.follows_border(leading - first) && end.transition != Transition::touching)
    result.transition = end.transition == Transition::in ? Transition::out : Transition::in;
  return result;
}

/// Whether a component runs along a line on which parts of the triangle meet.
bool runs_along_seam(const SurfaceComponent& component, std::size_t index) {
  for (std::size_t k = 2 * index; k < 2 * index + 2; ++k) {
    const double kept = component.points.front().parameters[k];
    if (component.start.side[k] != 0 && component.start.side[k] == component.end.side[k] && kept != 0 &&
        std::all_of(component.points.begin(), component.points.end(),
                    [&](const SurfacePoint& point) { return point.parameters[k] == kept; }))
      return true;
  }
  return false;
}

}  // namespace

void to_triangle_parameters(SurfaceResult& result, const TriangleCorner& corner, std::size_t index) {
  const auto map_point = [&](SurfacePoint& point) {
    double& u = point.parameters[2 * index];
    double& v = point.parameters[2 * index + 1];
    const std::array<double, 2> place = corner.at(u, v);
    u = place[0];
    v = place[1];
  };
  for (SurfaceComponent& component : result.components) {
    component.along_seam[index] = component.kind == SurfaceComponentKind::curve && runs_along_seam(component, index);
    if (!component.points.empty()) {
      component.start = end_in_triangle(component.start, component.points.front(), corner, index);
      component.end = end_in_triangle(component.end, component.points.back(), corner, index);
    }
    for (SurfacePoint& point : component.points) map_point(point);
  }
  for (SurfaceSingularPoint& point : result.singular_points) {
    map_point(point.at);
    // The derivatives of the map to the triangle are smaller, all together.
    point.radius *= 8;
  }
}

}  // namespace eliminant::intersect
