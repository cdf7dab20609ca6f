// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include <eliminant/intersect/whole_surfaces/surface_charts.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// The change of a parameter x = (a y + b) / (c y + d) of a projective line, ad - bc != 0.
struct ProjectiveChange {
  long a = 1;
  long b = 0;
  long c = 0;
  long d = 1;

  bool is_identity() const { return a == d && b == 0 && c == 0; }
  /// Increasing where it is finite, otherwise decreasing.
  bool is_increasing() const { return a * d - b * c > 0; }
  ProjectiveChange inverse() const { return {d, -b, -c, a}; }
  /// x for the value `other` of y.
  ProjectiveChange after(const ProjectiveChange& other) const {
    return {a * other.a + b * other.c, a * other.b + b * other.d, c * other.a + d * other.c, c * other.b + d * other.d};
  }
  double operator()(double y) const {
    return (static_cast<double>(a) * y + static_cast<double>(b)) /
           (static_cast<double>(c) * y + static_cast<double>(d));
  }
  /// Throws InvalidInput where x is infinite.
  symbolic::Rational operator()(const symbolic::Rational& y) const {
    return (symbolic::Rational(a) * y + symbolic::Rational(b)) / (symbolic::Rational(c) * y + symbolic::Rational(d));
  }
  /// Encloses all x; everything where one is infinite.
  DoubleInterval operator()(const DoubleInterval& y) const;
};

/// The chart of a projective line in which a parameter is its own inverse, or itself.
inline ProjectiveChange chart(bool inverted) { return inverted ? ProjectiveChange{0, 1, 1, 0} : ProjectiveChange{}; }

/// p with the changes made in its variables, times the least powers of their denominators: of the same degrees, or
/// lower ones where p vanishes at the parameter that becomes infinite. Two variables.
symbolic::Polynomial change_parameters(const symbolic::Polynomial& p, const std::array<long, 2>& degrees,
                                       const std::array<ProjectiveChange, 2>& changes);

/// The same surface in other parameters.
symbolic::RationalSurface change_parameters(const symbolic::RationalSurface& surface,
                                            const std::array<ProjectiveChange, 2>& changes);

/// The same surface with its parameters exchanged.
symbolic::RationalSurface exchange_parameters(const symbolic::RationalSurface& surface);

/// Weight constant: finite parameters have finite points, and infinite ones none.
bool is_polynomial(const symbolic::RationalSurface& surface);

/// Whether all real points of the curve on the lines at infinity of both variables are smooth on it, and it meets these
/// lines in as many different points as its degrees say.
bool is_general_at_infinity(const symbolic::Polynomial& curve);

}  // namespace eliminant::intersect
