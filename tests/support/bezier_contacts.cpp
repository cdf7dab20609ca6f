// SPDX-License-Identifier: BSD-3-Clause
#include <support/bezier_contacts.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <support/binary_numbers.hpp>

namespace eliminant::test {

Rational eighth(Random& random) { return fraction(random.between(1, 7), 8); }

namespace {

Map sum(const Map& a, const Map& b) {
  Map result;
  for (std::size_t k = 0; k < coordinates; ++k) result.push_back(a[k] + b[k]);
  return result;
}

}  // namespace

Map along(const ControlPoint& vector, const Polynomial& factor) {
  Map result;
  for (const Rational& coordinate : vector) result.push_back(coordinate * factor);
  return result;
}

RationalPolygon moved_through(RationalPolygon points, const Rational& t0, const ControlPoint& point) {
  const ControlPoint now = values(curve_map(points), {t0});
  for (ControlPoint& control : points)
    for (std::size_t k = 0; k + 1 < coordinates; ++k) control[k] = control[k] + point[k] - now[k];
  return points;
}

namespace {

/// The remainder modulo q of every coordinate. Denominators are powers of the leading coefficient of q.
Map remainder(const Map& map, const Polynomial& q) {
  const auto degree = static_cast<std::size_t>(q.degree(0));
  const Rational leading = ascending_coefficients(q, degree).back();
  Map result;
  for (Polynomial p : map) {
    while (p.degree(0) >= static_cast<long>(degree)) {
      const auto now = static_cast<std::size_t>(p.degree(0));
      p = p - (ascending_coefficients(p, now).back() / leading) * t_power(now - degree) * q;
    }
    result.push_back(std::move(p));
  }
  return result;
}

/// A line a + b t, b not 0, whose value at `at` lies well inside (0, 1).
Polynomial line_inside(Random& random, double at) {
  constexpr long parts = 4;
  for (;;) {
    const long start = random.between(-2, 6);
    const long slope = random.nonzero(3);
    const double there = (static_cast<double>(start) + static_cast<double>(slope) * at) / parts;
    if (there > 0.15 && there < 0.85) return in_t({fraction(start, parts), fraction(slope, parts)});
  }
}

Polynomial shifted_line(const Rational& value_at_t0, const Rational& slope, const Rational& t0) {
  return in_t({value_at_t0 - slope * t0, slope});
}

/// A curve of the degree that has contact of the order, at the rational t0, with the image of `path` under `map`:
/// the Taylor polynomial of that image, and random terms from (t - t0)^order on.
Map osculating(Drawing& drawing, const Map& map, const std::vector<Polynomial>& path, const Rational& t0,
               unsigned long order, unsigned long degree) {
  const Polynomial factor = in_t({-t0, Rational(1)});
  Map result = remainder(composed(map, path), power(factor, order));
  for (unsigned long k = order; k <= degree; ++k) result = sum(result, along(drawing.vector(), power(factor, k)));
  return result;
}

/// Of the patch at these approximate parameters, in sixteenths, so long that the largest component is 1.
ControlPoint near_normal(const Map& patch, double u, double v) {
  std::array<std::array<double, 3>, 2> tangents{};
  const std::vector<Rational> at{fraction(std::lround(u * 4096), 4096), fraction(std::lround(v * 4096), 4096)};
  const auto number = [](const Rational& exact) {
    return fmpz_get_d(exact.numerator().get()) / fmpz_get_d(exact.denominator().get());
  };
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t k = 0; k < 3; ++k) {
      // The derivative of x / w up to the factor w^2.
      const Polynomial slope = patch[k].derivative(axis) * patch[3] - patch[k] * patch[3].derivative(axis);
      tangents[axis][k] = number(value(slope, at));
    }
  const auto& [a, b] = tangents;
  std::array<double, 3> normal{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  double largest = 0;
  for (const double component : normal) largest = std::max(largest, std::abs(component));
  ControlPoint result;
  for (const double component : normal) result.push_back(fraction(std::lround(16 * component / largest), 16));
  return result;
}

/// Of a plane curve.
ControlPoint near_normal(const Map& curve, double u) {
  const std::vector<Rational> at{fraction(std::lround(u * 4096), 4096)};
  const auto slope = [&](std::size_t k) {
    return value(curve[k].derivative(0) * curve[3] - curve[k] * curve[3].derivative(0), at);
  };
  const auto number = [](const Rational& exact) {
    return fmpz_get_d(exact.numerator().get()) / fmpz_get_d(exact.denominator().get());
  };
  const double x = -number(slope(1));
  const double y = number(slope(0));
  const double largest = std::max(std::abs(x), std::abs(y));
  return {fraction(std::lround(16 * x / largest), 16), fraction(std::lround(16 * y / largest), 16), Rational(0)};
}

double approximate(const Polynomial& p, double t) {
  double result = 0;
  for (const Polynomial::Term& term : p.terms())
    result += fmpz_get_d(term.coefficient.numerator().get()) / fmpz_get_d(term.coefficient.denominator().get()) *
              std::pow(t, static_cast<double>(term.exponents[0]));
  return result;
}

bool has_positive_weights(const RationalPolygon& polygon) {
  return std::all_of(polygon.begin(), polygon.end(), [](const ControlPoint& point) { return point.back().sign() > 0; });
}

}  // namespace

Contact contact_at_dyadic(Drawing drawing, unsigned long order, Place place) {
  for (;;) {
    const RationalNet net = drawing.net(3, 3);
    const Map patch = homogeneous_map(net);
    const Rational t0 = place == Place::end ? Rational(drawing.random.between(0, 1)) : eighth(drawing.random);
    const Rational u0 = place == Place::border ? Rational(drawing.random.between(0, 1)) : eighth(drawing.random);
    const Rational v0 = eighth(drawing.random);
    const Rational slope_u = fraction(drawing.random.nonzero(4), 4);
    const Rational slope_v = fraction(drawing.random.nonzero(4), 4);
    const std::vector<Polynomial> path{shifted_line(u0, slope_u, t0), shifted_line(v0, slope_v, t0)};
    const RationalPolygon curve = control_polygon(osculating(drawing, patch, path, t0, order, 3), 3);
    if (has_positive_weights(curve))
      return {curve, net, near_normal(patch, exact_double(u0), exact_double(v0)), planted_at(t0, order)};
  }
}

Contact contact_at_root(Drawing drawing, const Quadratic& q, unsigned long order) {
  const RationalNet net = drawing.net(3, 3);
  const Map patch = homogeneous_map(net);
  const std::vector<Polynomial> path{line_inside(drawing.random, q.root()), line_inside(drawing.random, q.root())};
  const Map curve = remainder(composed(patch, path), power(q.polynomial(), order));
  return {control_polygon(curve, 2 * order - 1), net,
          near_normal(patch, approximate(path[0], q.root()), approximate(path[1], q.root())), q.planted(order)};
}

Contact flat_contact_at_root(Drawing drawing, const Quadratic& q) {
  Random& random = drawing.random;
  Polynomial y = in_t({fraction(random.between(0, 2), 8), Rational(1)});
  if (approximate(y, q.root()) > 0.9) y = in_t({Rational(1), Rational(-1)});
  std::vector<Polynomial::Term> terms;
  for (unsigned long i = 0; i <= 3; ++i)
    for (unsigned long j = 0; j <= 3; ++j) terms.push_back({drawing.around(0, 10), {i, j}});
  Polynomial f = Polynomial::from_terms(2, terms);
  std::vector<Rational> g;
  for (int i = 0; i <= 3; ++i) g.push_back(drawing.around(0, 10));
  const Polynomial t = t_power(1);
  const Polynomial aim = in_t(g) + fraction(random.nonzero(4), 4) * power(q.polynomial(), 3);
  const std::vector<Polynomial> path{t, y};
  for (unsigned long degree = 6;; --degree) {
    const Polynomial rest = aim - f.compose(path);
    const Rational coefficient = ascending_coefficients(rest, 6)[degree];
    const unsigned long i = std::min(degree, 3UL);
    const unsigned long j = degree - i;
    const Rational sign = j % 2 == 1 && ascending_coefficients(y, 1)[1].sign() < 0 ? Rational(-1) : Rational(1);
    f = f + Polynomial::from_terms(2, std::vector<Polynomial::Term>{{sign * coefficient, {i, j}}});
    if (degree == 0) break;
  }
  const Map patch{Polynomial::variable(2, 0), Polynomial::variable(2, 1), f, Polynomial::constant(2, 1)};
  const Map curve{t, y, in_t(g), Polynomial::constant(1, 1)};
  return {control_polygon(curve, 3), control_net({patch[0], patch[1], patch[2], patch[3]}, 3, 3),
          near_normal(patch, q.root(), approximate(y, q.root())), q.planted(3)};
}

Contact plane_contact_at_dyadic(Drawing drawing, unsigned long order, unsigned long degree) {
  const RationalPolygon second = drawing.wave(degree);
  const Map map = curve_map(second);
  const Rational t0 = fraction(drawing.random.between(1, 3), 4);
  const Rational u0 = fraction(drawing.random.between(1, 3), 4);
  const std::vector<Polynomial> path{shifted_line(u0, fraction(drawing.random.nonzero(4), 4), t0)};
  const Map curve = osculating(drawing, map, path, t0, order, degree);
  return {control_polygon(curve, degree), {second}, near_normal(map, exact_double(u0)), planted_at(t0, order)};
}

Contact plane_contact_at_root(Drawing drawing, const Quadratic& q, unsigned long order) {
  const RationalPolygon second = drawing.wave(3);
  const Map map = curve_map(second);
  const Polynomial bend = fraction(drawing.random.nonzero(2), 4) * q.polynomial();
  const std::vector<Polynomial> path{line_inside(drawing.random, q.root()) + bend};
  const Map curve = remainder(composed(map, path), power(q.polynomial(), order));
  return {control_polygon(curve, 2 * order - 1),
          {second},
          near_normal(map, approximate(path[0], q.root())),
          q.planted(order)};
}

BezierCase case_of(const std::string& family, const Contact& contact, bool plane) {
  BezierCase result = plane ? plane_case(family, contact.curve, contact.other.front())
                            : binary_case(family, contact.curve, contact.other);
  result.planted.push_back(contact.planted);
  return result;
}

BezierCase pushed_off(const std::string& family, Contact contact, bool plane, long exponent, bool outwards) {
  Rational distance(1);
  for (long k = 0; k < exponent; ++k) distance = distance * fraction(1, 2);
  if (!outwards) distance = -distance;
  for (ControlPoint& point : contact.curve)
    for (std::size_t k = 0; k + 1 < coordinates; ++k) point[k] = point[k] + distance * contact.normal[k] * point.back();
  BezierCase result = case_of(family, contact, plane);
  result.planted.clear();
  result.pushed = PushedContact{contact.planted.approximation, contact.planted.multiplicity, exponent, outwards};
  return result;
}

}  // namespace eliminant::test
