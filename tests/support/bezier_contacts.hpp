// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <support/bezier_maps.hpp>

/// Random curves and patches, and contacts planted in them.
namespace eliminant::test {

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

Rational eighth(Random& random);

/// factor(t) times a constant vector.
Map along(const ControlPoint& vector, const Polynomial& factor);

/// Moved, by polynomials of weight 1, so that the point of parameter t0 is P.
RationalPolygon moved_through(RationalPolygon points, const Rational& t0, const ControlPoint& point);

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

inline const std::vector<Quadratic> quadratics{{{-1, 0, 2}}, {{-1, 1, 1}}, {{-1, 2, 4}}, {{-1, 2, 2}},
                                               {{-3, 0, 4}}, {{-1, 4, 4}}, {{1, -4, 2}}, {{1, -3, 1}},
                                               {{-5, 4, 4}}, {{1, -6, 4}}, {{-7, 6, 4}}, {{-1, 3, 2}}};

/// A contact before it is written in doubles.
struct Contact {
  RationalPolygon curve;
  RationalNet other;
  ControlPoint normal;
  PlantedParameter planted;
};

enum class Place { inner, border, end };

/// A cubic, by its Taylor polynomial.
Contact contact_at_dyadic(Drawing drawing, unsigned long order, Place place = Place::inner);

/// c = S(line) modulo q^order: a cubic for order 2, a quintic for order 3.
Contact contact_at_root(Drawing drawing, const Quadratic& q, unsigned long order);

/// A graph z = f(x, y), bicubic, and a cubic (t, b + t or b - t, g(t)) with f(t, b +- t) = g + scale q^3.
Contact flat_contact_at_root(Drawing drawing, const Quadratic& q);

Contact plane_contact_at_dyadic(Drawing drawing, unsigned long order, unsigned long degree);

/// c = S(parabola) modulo q^order, of degree 3 or 5.
Contact plane_contact_at_root(Drawing drawing, const Quadratic& q, unsigned long order);

BezierCase case_of(const std::string& family, const Contact& contact, bool plane);

BezierCase pushed_off(const std::string& family, Contact contact, bool plane, long exponent, bool outwards);

}  // namespace eliminant::test
