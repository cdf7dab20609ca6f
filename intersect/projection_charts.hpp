// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>

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
  /// x for y; +inf where it is infinite. y may be infinite.
  double operator()(double y) const {
    const double infinity = std::numeric_limits<double>::infinity();
    if (y == infinity || y == -infinity) return c == 0 ? infinity : static_cast<double>(a) / static_cast<double>(c);
    const double below = static_cast<double>(c) * y + static_cast<double>(d);
    return below == 0 ? infinity : (static_cast<double>(a) * y + static_cast<double>(b)) / below;
  }
};

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
