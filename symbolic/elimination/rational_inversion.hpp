// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// A parameter of a surface as a quotient of two forms of one degree in its point (x, y, z, w).
struct ParameterQuotient {
  Polynomial numerator{4};
  Polynomial denominator{4};
};

/// The way back from the points of a surface of low degree to its parameters, by moving planes and quadrics of degree 1
/// in one parameter and 0 in the other.
struct RationalInversion {
  /// Irreducible form in x, y, z, w with integer coefficients, zero on the surface.
  Polynomial equation{4};
  /// Of s and of t: every (s, t) of a point satisfies s = numerator / denominator, unless both vanish there.
  std::array<std::vector<ParameterQuotient>, 2> parameters;
  /// A real point with w != 0 on `equation` = 0 on which one of these is not zero is the image of one pair of real
  /// parameters, infinite ones included, and of no other, complex ones included. One that is constant serves all
  /// points.
  std::vector<Polynomial> witnesses;
  /// All real points with w != 0 on `equation` = 0 without a witness are proven to be images of whole lines of real
  /// parameters (symbolic/elimination/exceptional_points).
  bool exceptions_are_lines = false;

  bool is_inverse_everywhere() const;
};

/// The form of least degree in x, y, z, w that vanishes on a tensor-product surface, where that is `largest_degree` or
/// less: its equation. nullopt too where the image is a curve.
std::optional<Polynomial> low_equation(const RationalSurface& surface, unsigned long largest_degree = 4);

/// Planes and proper parametrisations of quadrics and of many ruled surfaces have one by linear forms, tori by
/// quadratic ones; nullopt for surfaces of degree above 4, or where a parameter is no such quotient (maps that cover
/// the image several times).
/// Method: with s = L/L', t = K/K' the map B gives B(s, t) = G (x : y : z : w) modulo the equation, for a form G found
/// by linear algebra and freed of powers of w; where G is not zero B is defined there. The quotients hold on all of
/// the surface because it is the closure of the image.
std::optional<RationalInversion> rational_inversion(const RationalSurface& surface);

}  // namespace eliminant::symbolic
