// SPDX-License-Identifier: BSD-3-Clause
#include <support/bezier_families.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <utility>

#include <eliminant/symbolic/geometry/bezier.hpp>
#include <support/curves.hpp>

namespace eliminant::test {

namespace {

using symbolic::ControlPoint;
using symbolic::Integer;

using RationalPolygon = std::vector<ControlPoint>;
using RationalNet = std::vector<RationalPolygon>;
/// Homogeneous coordinates, the weight last: polynomials in t, or in the two parameters of a patch.
using Map = std::vector<Polynomial>;

constexpr std::size_t coordinates = 4;
const symbolic::Interval unit{0, 1};

Rational fraction(long numerator, long denominator) { return Rational(Integer(numerator), Integer(denominator)); }

Polynomial t_power(unsigned long exponent) {
  return Polynomial::from_terms(1, std::vector<Polynomial::Term>{{Rational(1), {exponent}}});
}

/// first + second t + ...
Polynomial in_t(const std::vector<Rational>& ascending) {
  std::vector<Polynomial::Term> terms;
  for (std::size_t i = 0; i < ascending.size(); ++i) terms.push_back({ascending[i], {i}});
  return Polynomial::from_terms(1, terms);
}

std::vector<Rational> ascending_coefficients(const Polynomial& p, std::size_t degree) {
  std::vector<Rational> result(degree + 1);
  for (const Polynomial::Term& term : p.terms()) result.at(term.exponents[0]) = term.coefficient;
  return result;
}

Rational value(const Polynomial& p, const std::vector<Rational>& point) {
  std::vector<Polynomial> images;
  for (const Rational& coordinate : point) images.push_back(Polynomial::constant(1, coordinate));
  return p.compose(images).constant_term();
}

ControlPoint values(const Map& map, const std::vector<Rational>& point) {
  ControlPoint result;
  for (const Polynomial& p : map) result.push_back(value(p, point));
  return result;
}

Map composed(const Map& map, const std::vector<Polynomial>& parameters) {
  Map result;
  for (const Polynomial& p : map) result.push_back(p.compose(parameters));
  return result;
}

Map curve_map(const RationalPolygon& points) {
  Map result;
  for (std::size_t k = 0; k < coordinates; ++k) {
    std::vector<Rational> bernstein;
    for (const ControlPoint& point : points) bernstein.push_back(point[k]);
    result.push_back(in_t(symbolic::power_coefficients(bernstein, unit)));
  }
  return result;
}

RationalPolygon control_polygon(const Map& map, std::size_t degree) {
  RationalPolygon points(degree + 1, ControlPoint(coordinates));
  for (std::size_t k = 0; k < coordinates; ++k) {
    const auto bernstein = symbolic::bernstein_coefficients(ascending_coefficients(map[k], degree), unit);
    for (std::size_t i = 0; i <= degree; ++i) points[i][k] = bernstein[i];
  }
  return points;
}

/// Columns first, then rows.
Map patch_map(const RationalNet& net) {
  Map result;
  for (std::size_t k = 0; k < coordinates; ++k) {
    Polynomial sum(2);
    std::vector<std::vector<Rational>> rows;
    for (const RationalPolygon& row : net) {
      std::vector<Rational> bernstein;
      for (const ControlPoint& point : row) bernstein.push_back(point[k]);
      rows.push_back(symbolic::power_coefficients(bernstein, unit));
    }
    std::vector<Polynomial::Term> terms;
    for (std::size_t j = 0; j < rows.front().size(); ++j) {
      std::vector<Rational> column;
      for (const auto& row : rows) column.push_back(row[j]);
      const auto power = symbolic::power_coefficients(column, unit);
      for (std::size_t i = 0; i < power.size(); ++i) terms.push_back({power[i], {i, j}});
    }
    result.push_back(Polynomial::from_terms(2, terms));
  }
  return result;
}

RationalNet control_net(const Map& map, std::size_t m, std::size_t n) {
  RationalNet net(m + 1, RationalPolygon(n + 1, ControlPoint(coordinates)));
  for (std::size_t k = 0; k < coordinates; ++k) {
    std::vector<std::vector<Rational>> power(m + 1, std::vector<Rational>(n + 1));
    for (const Polynomial::Term& term : map[k].terms())
      power.at(term.exponents[0]).at(term.exponents[1]) = term.coefficient;
    for (auto& row : power) row = symbolic::bernstein_coefficients(row, unit);
    for (std::size_t j = 0; j <= n; ++j) {
      std::vector<Rational> column;
      for (const auto& row : power) column.push_back(row[j]);
      const auto bernstein = symbolic::bernstein_coefficients(column, unit);
      for (std::size_t i = 0; i <= m; ++i) net[i][j][k] = bernstein[i];
    }
  }
  return net;
}

// From exact numbers to doubles.

/// The common denominator without its powers of two.
Integer odd_denominator(const RationalNet& net, Integer denominator = 1) {
  for (const RationalPolygon& row : net)
    for (const ControlPoint& point : row)
      for (const Rational& number : point) fmpz_lcm(denominator.get(), denominator.get(), fmpq_denref(number.get()));
  const auto twos = fmpz_val2(denominator.get());
  fmpz_tdiv_q_2exp(denominator.get(), denominator.get(), twos);
  return denominator;
}

void scale(RationalNet& net, const Integer& factor, std::size_t count) {
  for (RationalPolygon& row : net)
    for (ControlPoint& point : row)
      for (std::size_t k = 0; k < count; ++k) point[k] = point[k] * Rational(factor);
}

bool has_unit_weights(const RationalNet& net) {
  return std::all_of(net.begin(), net.end(), [](const RationalPolygon& row) {
    return std::all_of(row.begin(), row.end(), [](const ControlPoint& point) { return point.back() == Rational(1); });
  });
}

ControlNet in_doubles(const RationalNet& net) {
  ControlNet result;
  for (const RationalPolygon& row : net) {
    result.emplace_back();
    for (const ControlPoint& point : row) {
      HomogeneousPoint& converted = result.back().emplace_back();
      std::transform(point.begin(), point.end(), converted.begin(), exact_double);
    }
  }
  return result;
}

/// A case of these two objects. Odd denominators are multiplied away: together from the coordinates where all weights
/// are 1, else from the homogeneous coordinates of each.
BezierCase binary_case(std::string family, const RationalPolygon& curve, RationalNet other) {
  RationalNet first{curve};
  const std::size_t affine = coordinates - 1;
  if (has_unit_weights(first) && has_unit_weights(other)) {
    const Integer factor = odd_denominator(other, odd_denominator(first));
    scale(first, factor, affine);
    scale(other, factor, affine);
  } else {
    scale(first, odd_denominator(first), coordinates);
    scale(other, odd_denominator(other), coordinates);
  }
  BezierCase result;
  result.family = std::move(family);
  result.curve = in_doubles(first).front();
  result.patch = in_doubles(other);
  return result;
}

BezierCase plane_case(std::string family, const RationalPolygon& first, const RationalPolygon& second) {
  BezierCase result = binary_case(std::move(family), first, {second});
  result.second = std::move(result.patch.front());
  result.patch.clear();
  return result;
}

PlantedParameter planted_at(const Rational& parameter, unsigned long multiplicity) {
  PlantedParameter result;
  result.polynomial = {-fmpz_get_si(parameter.numerator().get()), fmpz_get_si(parameter.denominator().get())};
  result.approximation = exact_double(parameter);
  result.multiplicity = multiplicity;
  return result;
}

// Random objects.

/// Coordinates in units of 1 / resolution.
struct Drawing {
  Random& random;
  long resolution = 1024;
  bool rational = false;
  bool plane = false;

  Rational number(long low, long high) { return fraction(random.between(low, high), resolution); }
  Rational around(const Rational& centre, long radius_in_tenths) {
    const long radius = resolution * radius_in_tenths / 10;
    return centre + number(-radius, radius);
  }
  /// Weight between 1/2 and 2, where there are weights.
  ControlPoint weighted(ControlPoint point) {
    const Rational weight = rational ? fraction(random.between(8, 32), 16) : Rational(1);
    for (Rational& coordinate : point) coordinate = coordinate * weight;
    point.push_back(weight);
    return point;
  }
  RationalPolygon polygon(std::size_t degree) {
    RationalPolygon points;
    for (std::size_t i = 0; i <= degree; ++i) {
      const Rational x = number(0, resolution);
      const Rational y = number(0, resolution);
      points.push_back(weighted({x, y, plane ? Rational(0) : around(0, 9)}));
    }
    return points;
  }
  /// Wavy over the unit square.
  RationalNet net(std::size_t m, std::size_t n) {
    RationalNet rows(m + 1);
    const auto step = [&](std::size_t i, std::size_t count) {
      return fraction(resolution * static_cast<long>(i) / static_cast<long>(count), resolution);
    };
    for (std::size_t i = 0; i <= m; ++i)
      for (std::size_t j = 0; j <= n; ++j) {
        const Rational x = around(step(i, m), 1);
        const Rational y = around(step(j, n), 1);
        rows[i].push_back(weighted({x, y, around(0, 6)}));
      }
    return rows;
  }
  /// A plane curve, wavy from left to right.
  RationalPolygon wave(std::size_t degree) {
    RationalPolygon points;
    for (std::size_t i = 0; i <= degree; ++i) {
      const Rational x = fraction(resolution * static_cast<long>(i) / static_cast<long>(degree), resolution);
      points.push_back(weighted({around(x, 1), around(0, 9), Rational(0)}));
    }
    return points;
  }
  /// A direction, of weight 0.
  ControlPoint vector() {
    ControlPoint result;
    for (std::size_t k = 0; k + 1 < coordinates; ++k) result.push_back(around(0, 10));
    if (plane) result[2] = Rational(0);
    result.emplace_back(0);
    return result;
  }
};

Rational eighth(Random& random) { return fraction(random.between(1, 7), 8); }

Map sum(const Map& a, const Map& b) {
  Map result;
  for (std::size_t k = 0; k < coordinates; ++k) result.push_back(a[k] + b[k]);
  return result;
}

/// factor(t) times a constant vector.
Map along(const ControlPoint& vector, const Polynomial& factor) {
  Map result;
  for (const Rational& coordinate : vector) result.push_back(coordinate * factor);
  return result;
}

/// Moved, by polynomials of weight 1, so that the point of parameter t0 is P.
RationalPolygon moved_through(RationalPolygon points, const Rational& t0, const ControlPoint& point) {
  const ControlPoint now = values(curve_map(points), {t0});
  for (ControlPoint& control : points)
    for (std::size_t k = 0; k + 1 < coordinates; ++k) control[k] = control[k] + point[k] - now[k];
  return points;
}

// Contacts.

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

/// A quadratic polynomial without rational roots, of which exactly one is in [0, 1]. Its leading coefficient is a power
/// of two, so that remainders keep binary coordinates.
struct Quadratic {
  std::array<long, 3> ascending;

  Polynomial polynomial() const { return in_t({Rational(ascending[0]), Rational(ascending[1]), ascending[2]}); }
  double root() const {
    const auto [c, b, a] = std::array{static_cast<double>(ascending[0]), static_cast<double>(ascending[1]),
                                      static_cast<double>(ascending[2])};
    const double spread = std::sqrt(b * b - 4 * a * c);
    const double upper = (-b + spread) / (2 * a);
    return upper <= 1 ? upper : (-b - spread) / (2 * a);
  }
  PlantedParameter planted(unsigned long multiplicity) const {
    return {{ascending.begin(), ascending.end()}, root(), multiplicity};
  }
};

const std::vector<Quadratic> quadratics{{{-1, 0, 2}}, {{-1, 1, 1}}, {{-1, 2, 4}}, {{-1, 2, 2}},
                                        {{-3, 0, 4}}, {{-1, 4, 4}}, {{1, -4, 2}}, {{1, -3, 1}},
                                        {{-5, 4, 4}}, {{1, -6, 4}}, {{-7, 6, 4}}, {{-1, 3, 2}}};

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

/// A contact before it is written in doubles.
struct Contact {
  RationalPolygon curve;
  RationalNet other;
  ControlPoint normal;
  PlantedParameter planted;
};

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

enum class Place { inner, border, end };

/// A cubic, by its Taylor polynomial.
Contact contact_at_dyadic(Drawing drawing, unsigned long order, Place place = Place::inner) {
  for (;;) {
    const RationalNet net = drawing.net(3, 3);
    const Map patch = patch_map(net);
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

/// c = S(line) modulo q^order: a cubic for order 2, a quintic for order 3.
Contact contact_at_root(Drawing drawing, const Quadratic& q, unsigned long order) {
  const RationalNet net = drawing.net(3, 3);
  const Map patch = patch_map(net);
  const std::vector<Polynomial> path{line_inside(drawing.random, q.root()), line_inside(drawing.random, q.root())};
  const Map curve = remainder(composed(patch, path), power(q.polynomial(), order));
  return {control_polygon(curve, 2 * order - 1), net,
          near_normal(patch, approximate(path[0], q.root()), approximate(path[1], q.root())), q.planted(order)};
}

/// A graph z = f(x, y), bicubic, and a cubic (t, b + t or b - t, g(t)) with f(t, b +- t) = g + scale q^3.
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
  return {control_polygon(curve, 3), control_net(patch, 3, 3), near_normal(patch, q.root(), approximate(y, q.root())),
          q.planted(3)};
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

/// c = S(parabola) modulo q^order, of degree 3 or 5.
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

// The families.

class Collection {
 public:
  explicit Collection(std::string only) : only_(std::move(only)) {}

  /// `make` draws one case; the numbers of a family do not depend on the others.
  void add(const std::string& family, unsigned long count, const std::function<BezierCase(Random&)>& make) {
    if (!only_.empty() && only_ != family) return;
    std::uint64_t seed = 2026;
    for (const char letter : family) seed = 31 * seed + static_cast<unsigned char>(letter);
    Random random(seed);
    for (unsigned long index = 0; index < count; ++index) {
      cases_.push_back(make(random));
      cases_.back().family = family;
      cases_.back().index = index;
    }
  }

  std::vector<BezierCase> take() { return std::move(cases_); }

 private:
  std::string only_;
  std::vector<BezierCase> cases_;
};

constexpr std::array<long, 3> push_exponents{13, 20, 27};

/// Six of each contact: three distances to both sides.
void add_pushed(Collection& all, const std::string& family, unsigned long contacts, bool plane,
                const std::function<Contact(Random&)>& make) {
  std::optional<Contact> contact;
  unsigned long step = 0;
  all.add(family, contacts * 2 * push_exponents.size(), [&, plane](Random& random) {
    if (step % (2 * push_exponents.size()) == 0) contact = make(random);
    const unsigned long which = step++ % (2 * push_exponents.size());
    return pushed_off(family, *contact, plane, push_exponents[which / 2], which % 2 == 0);
  });
}

void add_general(Collection& all) {
  const auto across = [&](const std::string& family, unsigned long count, std::size_t degree, std::size_t bidegree,
                          bool rational) {
    all.add(family, count, [=](Random& random) {
      Drawing drawing{random, 1024, rational, false};
      const RationalPolygon curve = drawing.polygon(degree);
      return binary_case({}, curve, drawing.net(bidegree, bidegree));
    });
  };
  across("segment x bicubic", 50, 1, 3, false);
  across("cubic x bicubic", 50, 3, 3, false);
  across("rational cubic x rational bicubic", 40, 3, 3, true);
  across("degree 8 x bidegree (5,5)", 20, 8, 5, false);
}

void add_borders(Collection& all) {
  // A cubic moved so that it meets S(u, v) at t0.
  const auto through = [](Random& random, const std::function<std::vector<Rational>(Random&)>& on_patch,
                          const std::function<Rational(Random&)>& on_curve) {
    Drawing drawing{random, 256, false, false};
    const RationalNet net = drawing.net(3, 3);
    const Rational t0 = on_curve(random);
    const RationalPolygon curve = moved_through(drawing.polygon(3), t0, values(patch_map(net), on_patch(random)));
    BezierCase result = binary_case({}, curve, net);
    result.planted.push_back(planted_at(t0, 1));
    return result;
  };
  const auto corner = [](Random& random) {
    return std::vector<Rational>{Rational(random.between(0, 1)), Rational(random.between(0, 1))};
  };
  const auto border = [](Random& random) {
    std::vector<Rational> point{eighth(random), Rational(random.between(0, 1))};
    if (random.between(0, 1) == 0) std::swap(point[0], point[1]);
    return point;
  };
  const auto inner = [](Random& random) { return std::vector<Rational>{eighth(random), eighth(random)}; };
  const auto end = [](Random& random) { return Rational(random.between(0, 1)); };
  all.add("through a corner", 12, [&](Random& random) { return through(random, corner, eighth); });
  all.add("through a border", 12, [&](Random& random) { return through(random, border, eighth); });
  all.add("ending on a border", 12, [&](Random& random) { return through(random, border, end); });
  all.add("ending in a corner", 8, [&](Random& random) { return through(random, corner, end); });
  all.add("ending on the patch", 20, [&](Random& random) { return through(random, inner, end); });
}

void add_contained(Collection& all) {
  // S(line): most lines stay in the domain, some enter it at 1/4 and leave it at 3/4.
  const auto image = [](Random& random, bool rational, const std::vector<Polynomial>& path, std::size_t degree,
                        bool leaves) {
    Drawing drawing{random, 64, rational, false};
    const RationalNet net = drawing.net(3, 3);
    BezierCase result = binary_case({}, control_polygon(composed(patch_map(net), path), degree), net);
    result.overlap = leaves ? std::array{0.25, 0.75} : std::array{0.0, 1.0};
    return result;
  };
  const Polynomial leaving = in_t({fraction(-1, 2), Rational(2)});
  unsigned long turn = 0;
  all.add("along a border", 12, [&](Random& random) {
    const bool leaves = ++turn % 3 == 0;
    std::vector<Polynomial> path{leaves ? leaving : t_power(1), Polynomial::constant(1, random.between(0, 1))};
    if (turn % 2 == 0) std::swap(path[0], path[1]);
    return image(random, turn % 4 == 0, path, 3, leaves);
  });
  all.add("on the patch", 15, [&](Random& random) {
    const bool leaves = ++turn % 3 == 0;
    const Rational v0 = eighth(random);
    const Rational v1 = eighth(random);
    std::vector<Polynomial> path{leaves ? leaving : in_t({fraction(1, 8), fraction(3, 4)}), in_t({v0, v1 - v0})};
    if (turn % 2 == 0) std::swap(path[0], path[1]);
    return image(random, turn % 4 == 0, path, 6, leaves);
  });
}

void add_contacts(Collection& all) {
  const auto drawing = [](Random& random, long resolution, bool rational, bool plane) {
    return Drawing{random, resolution, rational, plane};
  };
  std::size_t turn = 0;
  const auto next = [&]() -> const Quadratic& { return quadratics[turn++ % quadratics.size()]; };
  const std::string order_2 = "contact of order 2";
  const std::string order_3 = "contact of order 3";
  all.add(order_2, 17,
          [&](Random& r) { return case_of({}, contact_at_dyadic(drawing(r, 256, false, false), 2), false); });
  all.add(order_3, 17,
          [&](Random& r) { return case_of({}, contact_at_dyadic(drawing(r, 256, false, false), 3), false); });
  for (const unsigned long order : {2UL, 3UL}) {
    const std::string of_order = "contact of order " + std::to_string(order);
    all.add(of_order + " on a border", 8, [&](Random& r) {
      return case_of({}, contact_at_dyadic(drawing(r, 256, false, false), order, Place::border), false);
    });
    all.add(of_order + " at an end", 8, [&](Random& r) {
      return case_of({}, contact_at_dyadic(drawing(r, 256, false, false), order, Place::end), false);
    });
  }
  all.add("rational contact of order 2", 8,
          [&](Random& r) { return case_of({}, contact_at_dyadic(drawing(r, 64, true, false), 2), false); });
  all.add("rational contact of order 3", 8,
          [&](Random& r) { return case_of({}, contact_at_dyadic(drawing(r, 64, true, false), 3), false); });
  all.add("irrational contact of order 2", 20,
          [&](Random& r) { return case_of({}, contact_at_root(drawing(r, 64, false, false), next(), 2), false); });
  all.add("irrational contact of order 3", 18,
          [&](Random& r) { return case_of({}, flat_contact_at_root(drawing(r, 64, false, false), next()), false); });
  all.add("irrational contact of order 3, quintic", 6,
          [&](Random& r) { return case_of({}, contact_at_root(drawing(r, 64, false, false), next(), 3), false); });
  add_pushed(all, "pushed contact of order 2", 4, false,
             [&](Random& r) { return contact_at_dyadic(drawing(r, 256, false, false), 2); });
  add_pushed(all, "pushed contact of order 3", 4, false,
             [&](Random& r) { return contact_at_dyadic(drawing(r, 256, false, false), 3); });
  add_pushed(all, "pushed irrational contact of order 2", 3, false,
             [&](Random& r) { return contact_at_root(drawing(r, 64, false, false), next(), 2); });
  add_pushed(all, "pushed irrational contact of order 3", 2, false,
             [&](Random& r) { return flat_contact_at_root(drawing(r, 64, false, false), next()); });
}

void add_plane(Collection& all) {
  const auto pairs = [&](const std::string& family, unsigned long count, std::size_t degree, bool rational) {
    all.add(family, count, [=](Random& random) {
      Drawing drawing{random, 1024, rational, true};
      const RationalPolygon first = drawing.polygon(degree);
      return plane_case({}, first, drawing.polygon(degree));
    });
  };
  pairs("plane cubic x cubic", 60, 3, false);
  pairs("plane rational cubic x cubic", 20, 3, true);
  pairs("plane degree 8 x 8", 30, 8, false);

  std::size_t turn = 0;
  const auto next = [&]() -> const Quadratic& { return quadratics[turn++ % quadratics.size()]; };
  const auto drawing = [](Random& random) { return Drawing{random, 64, false, true}; };
  for (const unsigned long order : {2UL, 3UL}) {
    const std::string of_order = "contact of order " + std::to_string(order);
    all.add("plane " + of_order, 12,
            [&](Random& r) { return case_of({}, plane_contact_at_dyadic(drawing(r), order, 3), true); });
    all.add("plane " + of_order + ", degree 8", 4,
            [&](Random& r) { return case_of({}, plane_contact_at_dyadic(drawing(r), order, 8), true); });
    all.add("plane irrational " + of_order, 10,
            [&](Random& r) { return case_of({}, plane_contact_at_root(drawing(r), next(), order), true); });
    add_pushed(all, "plane pushed " + of_order, 4, true,
               [&](Random& r) { return plane_contact_at_dyadic(drawing(r), order, 3); });
    add_pushed(all, "plane pushed irrational " + of_order, 2, true,
               [&](Random& r) { return plane_contact_at_root(drawing(r), next(), order); });
  }

  all.add("plane common end point", 20, [&](Random& random) {
    Drawing drawing{random, 1024, random.between(0, 2) == 0, true};
    RationalPolygon first = drawing.polygon(3);
    RationalPolygon second = drawing.polygon(3);
    const bool tangent = random.between(0, 3) == 0;
    second.front() = first.front();
    if (tangent) second[1] = first[1];
    if (random.between(0, 1) == 0) std::reverse(second.begin(), second.end());
    const bool at_end = random.between(0, 1) == 0;
    if (at_end) std::reverse(first.begin(), first.end());
    BezierCase result = plane_case({}, first, second);
    result.planted.push_back(planted_at(at_end ? 1 : 0, tangent ? 2 : 1));
    return result;
  });
  // The first is the arc of the second from 1/4 to 5/4, or from 1/4 to 3/4.
  all.add("plane common arc", 10, [&](Random& random) {
    Drawing drawing{random, 256, random.between(0, 1) == 0, true};
    const RationalPolygon second = drawing.wave(3);
    const bool leaves = random.between(0, 1) == 0;
    const Polynomial arc = in_t({fraction(1, 4), leaves ? Rational(1) : fraction(1, 2)});
    BezierCase result = plane_case({}, control_polygon(composed(curve_map(second), {arc}), 3), second);
    result.overlap = {0, leaves ? 0.75 : 1};
    return result;
  });
}

std::vector<BezierCase> collected(const std::string& only) {
  Collection all(only);
  add_general(all);
  add_borders(all);
  add_contained(all);
  add_contacts(all);
  add_plane(all);
  return all.take();
}

/// [x, y, z, w] with the weight apart.
std::string point_text(const HomogeneousPoint& point) {
  const Rational weight = exact_rational(point.back());
  std::string result = "[";
  for (std::size_t k = 0; k + 1 < coordinates; ++k)
    result += '"' + (exact_rational(point[k]) / weight).to_string() + "\", ";
  return result + '"' + weight.to_string() + "\"]";
}

std::string polygon_text(const ControlPolygon& polygon) {
  std::string result = "[";
  for (const HomogeneousPoint& point : polygon) result += (result.size() > 1 ? ", " : "") + point_text(point);
  return result + "]";
}

std::string curve_text(const ControlPolygon& polygon) {
  return "{\"bezier\": {\"degree\": " + std::to_string(polygon.size() - 1) +
         ", \"control_points\": " + polygon_text(polygon) + "}}";
}

}  // namespace

std::vector<BezierCase> bezier_cases() { return collected({}); }

std::vector<BezierCase> bezier_cases(const std::string& family) { return collected(family); }

BezierCase reversed(BezierCase bezier) {
  std::reverse(bezier.curve.begin(), bezier.curve.end());
  for (PlantedParameter& planted : bezier.planted) {
    // p(1 - t), by Horner's rule.
    std::vector<long> turned;
    for (auto coefficient = planted.polynomial.rbegin(); coefficient != planted.polynomial.rend(); ++coefficient) {
      // Times 1 - t, plus the coefficient.
      turned.push_back(0);
      for (std::size_t i = turned.size(); i-- > 1;) turned[i] -= turned[i - 1];
      turned[0] += *coefficient;
    }
    planted.polynomial = turned;
    planted.approximation = 1 - planted.approximation;
  }
  if (bezier.overlap) bezier.overlap = std::array{1 - (*bezier.overlap)[1], 1 - (*bezier.overlap)[0]};
  if (bezier.pushed) bezier.pushed->parameter = 1 - bezier.pushed->parameter;
  return bezier;
}

BezierCase second_reversed(BezierCase bezier) {
  std::reverse(bezier.patch.begin(), bezier.patch.end());
  std::reverse(bezier.second.begin(), bezier.second.end());
  return bezier;
}

BezierCase swapped(BezierCase bezier) {
  std::swap(bezier.curve, bezier.second);
  bezier.planted.clear();
  bezier.overlap.reset();
  bezier.pushed.reset();
  return bezier;
}

std::string problem_json(const BezierCase& bezier) {
  if (bezier.in_plane())
    return "{\"problem\": \"curve_curve\", \"first\": " + curve_text(bezier.curve) +
           ", \"second\": " + curve_text(bezier.second) + "}\n";
  std::string rows = "[";
  for (const ControlPolygon& row : bezier.patch) rows += (rows.size() > 1 ? ", " : "") + polygon_text(row);
  return "{\"problem\": \"curve_surface\", \"curve\": " + curve_text(bezier.curve) +
         ", \"surface\": {\"bezier\": {\"degree\": [" + std::to_string(bezier.patch.size() - 1) + ", " +
         std::to_string(bezier.patch.front().size() - 1) + "], \"control_points\": " + rows + "]}}}\n";
}

}  // namespace eliminant::test
