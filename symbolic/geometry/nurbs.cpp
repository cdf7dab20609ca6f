// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/geometry/nurbs.hpp>

#include <algorithm>
#include <utility>

#include <eliminant/base/error.hpp>

namespace eliminant::symbolic {

namespace {

// ((upper - x) below + (x - lower) above) / (upper - lower): the polar form where one argument changes from lower (in
// `below`) and upper (in `above`) to x.
ControlPoint blend(const ControlPoint& below, const ControlPoint& above, const Rational& lower, const Rational& upper,
                   const Rational& x) {
  const Rational weight = (x - lower) / (upper - lower);
  const Rational rest = Rational(1) - weight;
  ControlPoint result(below.size());
  for (std::size_t c = 0; c < result.size(); ++c) result[c] = rest * below[c] + weight * above[c];
  return result;
}

// Bezier control points of the span [u_j, u_(j+1)], where knots[j] < knots[j + 1].
std::vector<ControlPoint> points_on_span(const KnotVector& vector, const std::vector<ControlPoint>& points,
                                         std::size_t j) {
  const std::size_t p = vector.degree;
  const std::vector<Rational>& u = vector.knots;
  const Rational& a = u[j];
  const Rational& b = u[j + 1];
  // After round r of de Boor's scheme current[k], k >= r, is f(a^r, u_(i+1), ..., u_(i+p-r)) with i = j - p + k; the
  // last of them has no knots below a.
  const auto first = points.begin() + static_cast<std::ptrdiff_t>(j - p);
  std::vector<ControlPoint> current(first, first + static_cast<std::ptrdiff_t>(p + 1));
  std::vector<ControlPoint> left(p + 1);  // left[k] = f(a^(p-k), u_(j+1), ..., u_(j+k))
  left[p] = current[p];
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t k = p; k >= r; --k) {
      const std::size_t i = j - p + k;
      current[k] = blend(current[k - 1], current[k], u[i], u[i + p - r + 1], a);
    }
    left[p - r] = current[p];
  }
  // Round r replaces one more knot above b by b: left[k] becomes f(a^(p-k), b^r, u_(j+1), ..., u_(j+k-r)), k >= r. The
  // first of them is a Bezier point.
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t k = p; k >= r; --k) left[k] = blend(left[k - 1], left[k], a, u[j + k - r + 1], b);
  return left;
}

}  // namespace

void require_knots(const KnotVector& vector, std::size_t control_points) {
  const std::size_t p = vector.degree;
  const std::vector<Rational>& u = vector.knots;
  if (p < 1) throw InvalidInput("the degree of a B-spline is 0", "a degree of at least 1");
  if (control_points < p + 1)
    throw InvalidInput(
        "a B-spline of degree " + std::to_string(p) + " has " + std::to_string(control_points) + " control points",
        "at least " + std::to_string(p + 1) + " points");
  if (u.size() != control_points + p + 1)
    throw InvalidInput("a knot vector has " + std::to_string(u.size()) + " knots for " +
                           std::to_string(control_points) + " control points of degree " + std::to_string(p),
                       std::to_string(control_points + p + 1) + " knots: control points + degree + 1");
  for (std::size_t i = 0; i + 1 < u.size(); ++i)
    if (u[i + 1] < u[i])
      throw InvalidInput("knot " + std::to_string(i + 2) + " is smaller than the knot before it",
                         "knots that do not decrease");
  if (!(u[p] < u[control_points]))
    throw InvalidInput("the domain of a knot vector is empty: knots " + std::to_string(p + 1) + " and " +
                           std::to_string(control_points + 1) + " are equal",
                       "a knot span of positive length between them");
  for (std::size_t i = 0; i + p + 1 < u.size(); ++i)
    if (u[i] == u[i + p + 1])
      throw InvalidInput("a knot occurs more than " + std::to_string(p + 1) + " times",
                         "at most degree + 1 equal knots");
}

std::vector<BezierSpan> bezier_spans(const KnotVector& vector, const std::vector<ControlPoint>& points) {
  require_knots(vector, points.size());
  for (const ControlPoint& point : points)
    if (point.size() != points.front().size())
      throw InvalidInput("control points differ in their number of coordinates", "points of one dimension");
  std::vector<BezierSpan> spans;
  for (std::size_t j = vector.degree; j < points.size(); ++j)
    if (vector.knots[j] < vector.knots[j + 1])
      spans.push_back({{vector.knots[j], vector.knots[j + 1]}, points_on_span(vector, points, j)});
  return spans;
}

ParametricCurve nurbs_curve(const KnotVector& knots, const std::vector<ControlPoint>& points) {
  ParametricCurve curve;
  for (const BezierSpan& span : bezier_spans(knots, points))
    curve.pieces.push_back(bezier_curve(span.points, span.span));
  return curve;
}

ParametricSurface nurbs_surface(const std::array<KnotVector, 2>& knots,
                                const std::vector<std::vector<ControlPoint>>& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  // A row is one point of a curve in the first parameter, with all its coordinates in sequence.
  std::vector<ControlPoint> long_points;
  for (const auto& row : rows) {
    if (row.size() != columns)
      throw InvalidInput(
          "rows of control points have " + std::to_string(columns) + " and " + std::to_string(row.size()) + " points",
          "rows of one length");
    ControlPoint all;
    for (const ControlPoint& point : row) {
      if (point.size() != 4)
        throw InvalidInput(
            "a control point of a surface has " + std::to_string(point.size()) + " homogeneous coordinates",
            "four, the weight last");
      all.insert(all.end(), point.begin(), point.end());
    }
    long_points.push_back(std::move(all));
  }
  ParametricSurface surface;
  for (const BezierSpan& first : bezier_spans(knots[0], long_points)) {
    // Transposed: for each column of control points, its Bezier points in the first parameter in sequence.
    const std::size_t row_count = first.points.size();
    std::vector<ControlPoint> transposed(columns);
    for (std::size_t column = 0; column < columns; ++column)
      for (const ControlPoint& row : first.points)
        transposed[column].insert(transposed[column].end(), row.begin() + static_cast<std::ptrdiff_t>(4 * column),
                                  row.begin() + static_cast<std::ptrdiff_t>(4 * column + 4));
    for (const BezierSpan& second : bezier_spans(knots[1], transposed)) {
      std::vector<std::vector<ControlPoint>> net(row_count);
      for (std::size_t i = 0; i < row_count; ++i)
        for (const ControlPoint& column : second.points)
          net[i].emplace_back(column.begin() + static_cast<std::ptrdiff_t>(4 * i),
                              column.begin() + static_cast<std::ptrdiff_t>(4 * i + 4));
      surface.pieces.push_back(bezier_patch(net, {first.span, second.span}));
    }
  }
  return surface;
}

}  // namespace eliminant::symbolic
