// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/geometry/cylinder_conditions.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>

namespace eliminant::symbolic {

namespace {

using Offsets = std::vector<SpacePoint>;

bool is_zero(const SpacePoint& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }
bool parallel(const SpacePoint& a, const SpacePoint& b) { return is_zero(cross_product(a, b)); }
Rational determinant(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  return dot_product(a, cross_product(b, c));
}

/// t.d as a form in t.
Polynomial linear_form(const SpacePoint& d) {
  Polynomial form(3);
  for (std::size_t i = 0; i < 3; ++i) form = form + d[i] * Polynomial::variable(3, i);
  return form;
}

/// (t x a).(t x b) = (t.t)(a.b) - (t.a)(t.b).
Polynomial product_of_projections(const SpacePoint& a, const SpacePoint& b) {
  Polynomial square(3);
  for (std::size_t i = 0; i < 3; ++i) square = square + Polynomial::variable(3, i) * Polynomial::variable(3, i);
  return dot_product(a, b) * square - linear_form(a) * linear_form(b);
}

/// sum_k w_k N_k of offsets and their relation.
Polynomial relation_conic(const Offsets& offsets, const std::vector<Rational>& weights) {
  Polynomial conic(3);
  for (std::size_t k = 0; k < offsets.size(); ++k)
    conic = conic + weights[k] * product_of_projections(offsets[k], offsets[k]);
  return conic.primitive_part();
}

Polynomial tetrahedron_cubic(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  const auto term = [](const SpacePoint& d, const SpacePoint& e, const SpacePoint& f) {
    return product_of_projections(d, d) * linear_form(cross_product(e, f));
  };
  return (term(a, b, c) + term(b, c, a) + term(c, a, b)).primitive_part();
}

/// The conditions of offsets that span the space; three of them where two points are one.
CylinderConditions in_space(const Offsets& offsets) {
  CylinderConditions result;
  if (offsets.size() == 3) {
    result.kind = CylinderConditions::Kind::infinite;
    result.reason = "two of the points are the same, and four points are on infinitely many cylinders";
    result.directions = tetrahedron_cubic(offsets[0], offsets[1], offsets[2]);
    return result;
  }
  std::vector<Rational> weights;
  std::size_t left_out = 4;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < 4; ++i)
      if (i != k) others.push_back(i);
    const Rational volume = determinant(offsets[others[0]], offsets[others[1]], offsets[others[2]]);
    weights.push_back(k % 2 == 0 ? volume : -volume);
    if (left_out == 4 && !volume.is_zero()) left_out = k;
  }
  result.first = relation_conic(offsets, weights);
  result.second =
      tetrahedron_cubic(offsets[(left_out + 1) % 4], offsets[(left_out + 2) % 4], offsets[(left_out + 3) % 4]);
  return result;
}

/// Coordinates (u, v) of points u a + v b of a plane.
struct PlaneCoordinates {
  SpacePoint a, b;
  std::vector<std::array<Rational, 2>> offsets;
};

PlaneCoordinates plane_coordinates(const Offsets& offsets) {
  PlaneCoordinates plane;
  plane.a = offsets.front();
  plane.b = *std::find_if(offsets.begin(), offsets.end(), [&](const SpacePoint& d) { return !parallel(plane.a, d); });
  const SpacePoint normal = cross_product(plane.a, plane.b);
  std::size_t k = 0;
  while (normal[k].is_zero()) ++k;
  for (const SpacePoint& d : offsets)
    plane.offsets.push_back({cross_product(d, plane.b)[k] / normal[k], cross_product(plane.a, d)[k] / normal[k]});
  return plane;
}

/// A row of rationals over their common denominator.
void set_row(IntegerMatrix& matrix, long row, const std::vector<Rational>& values) {
  Integer common(1);
  for (const Rational& value : values) fmpz_lcm(common.get(), common.get(), fmpq_denref(value.get()));
  for (std::size_t j = 0; j < values.size(); ++j) {
    const Rational cleared = values[j] * Rational(common);
    fmpz_set(matrix.entry(row, static_cast<long>(j)), fmpq_numref(cleared.get()));
  }
}

/// The conics A u^2 + B u v + C v^2 + D u + E v = 0 through the points, in columns.
IntegerMatrix conics_through(const PlaneCoordinates& plane) {
  IntegerMatrix conditions(static_cast<long>(plane.offsets.size()), 5);
  long row = 0;
  for (const auto& [u, v] : plane.offsets) set_row(conditions, row++, {u * u, u * v, v * v, u, v});
  return nullspace(conditions);
}

/// The relation of three offsets in a plane.
std::vector<Rational> plane_relation(const PlaneCoordinates& plane) {
  const auto area = [&plane](std::size_t i, std::size_t j) {
    return plane.offsets[i][0] * plane.offsets[j][1] - plane.offsets[i][1] * plane.offsets[j][0];
  };
  return {area(1, 2), area(2, 0), area(0, 1)};
}

/// The conditions of offsets that span a plane.
CylinderConditions in_plane(const Offsets& offsets) {
  CylinderConditions result;
  result.kind = CylinderConditions::Kind::infinite;
  const PlaneCoordinates plane = plane_coordinates(offsets);
  if (offsets.size() == 2) {
    result.reason = "three different points are on infinitely many cylinders";
    return result;
  }
  if (offsets.size() == 3) {
    result.reason = "two of the points are the same, and four points are on infinitely many cylinders";
    result.directions = relation_conic(offsets, plane_relation(plane));
    return result;
  }
  const IntegerMatrix conics = conics_through(plane);
  if (conics.columns() > 1) {
    result.reason = "all points are in a plane, and four of them on a line";
    return result;
  }
  std::array<Rational, 5> conic;
  for (long i = 0; i < 5; ++i) fmpz_set(fmpq_numref(conic[static_cast<std::size_t>(i)].get()), conics.entry(i, 0));
  const auto& [a, b, c, d, e] = conic;
  if ((b * b - Rational(4) * a * c).is_zero()) {
    // Four times the determinant of the conic without constant term.
    if ((b * d * e - a * e * e - c * d * d).is_zero()) {
      result.reason = "all points are in a plane on two parallel lines";
      return result;
    }
    result.kind = CylinderConditions::Kind::parabola;
    return result;
  }
  result.kind = CylinderConditions::Kind::coplanar;
  const Polynomial uu = product_of_projections(plane.a, plane.a);
  const Polynomial uv = Rational(2) * product_of_projections(plane.a, plane.b);
  const Polynomial vv = product_of_projections(plane.b, plane.b);
  // Two of the three minors, which imply the third: those with a coefficient that is not 0.
  const Polynomial uu_vv = (a * vv - c * uu).primitive_part();
  const Polynomial uu_uv = (a * uv - b * uu).primitive_part();
  const Polynomial uv_vv = (b * vv - c * uv).primitive_part();
  result.first = !a.is_zero() || !c.is_zero() ? uu_vv : uu_uv;
  result.second = !a.is_zero() ? uu_uv : uv_vv;
  return result;
}

}  // namespace

SpacePoint difference(const SpacePoint& a, const SpacePoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

SpacePoint cross_product(const SpacePoint& a, const SpacePoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot_product(const SpacePoint& a, const SpacePoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

CylinderConditions cylinder_conditions(const std::array<SpacePoint, 5>& points) {
  Offsets offsets;
  for (std::size_t k = 1; k < 5; ++k) {
    SpacePoint offset = difference(points[k], points[0]);
    if (!is_zero(offset) && std::find(offsets.begin(), offsets.end(), offset) == offsets.end())
      offsets.push_back(std::move(offset));
  }
  const auto on_first_line = [&](const SpacePoint& d) { return parallel(offsets.front(), d); };
  if (offsets.empty() || std::all_of(offsets.begin(), offsets.end(), on_first_line)) {
    CylinderConditions result;
    result.kind = CylinderConditions::Kind::infinite;
    result.reason = offsets.empty() ? "all points are the same" : "all points are on a line";
    return result;
  }
  const SpacePoint& second = *std::find_if_not(offsets.begin(), offsets.end(), on_first_line);
  const bool spans_space = std::any_of(offsets.begin(), offsets.end(), [&](const SpacePoint& d) {
    return !determinant(offsets.front(), second, d).is_zero();
  });
  return spans_space ? in_space(offsets) : in_plane(offsets);
}

}  // namespace eliminant::symbolic
