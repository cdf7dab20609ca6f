// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// The set of zeros of a polynomial f in x, y: vertical lines, and a curve without any.
struct ReducedCurve {
  /// Squarefree in x: its roots are the abscissae of the lines x = constant of f = 0.
  UnivariatePolynomial vertical_lines;
  /// Squarefree over Q[x, y], primitive over Z, no factor in x alone.
  Polynomial rest{2};
  /// A factor of f occurs more than once.
  bool repeated_factor = false;
};

/// The squarefree part f / gcd(f, f_x, f_y) without its content over Z[x]. f has two variables and is not zero.
ReducedCurve reduced_curve(const Polynomial& f);

/// The polynomial g(x, y) in y for a rational x, times a number that is not zero: g given with x hidden.
UnivariatePolynomial on_vertical_line(const HiddenVariablePolynomial& g, const Rational& x);

/// g(x, y) in x for a rational y; zero where y - constant divides g.
UnivariatePolynomial on_horizontal_line(const Polynomial& g, const Rational& y);

/// A squarefree polynomial in x that vanishes at every abscissa where the number or the order of the real points of
/// rest = 0 above x may change: where the discriminant of `rest` in y or its leading coefficient is zero, on the
/// vertical lines, and at the roots of `others` (those that are zero are left out).
UnivariatePolynomial event_polynomial(const ReducedCurve& curve, const std::vector<UnivariatePolynomial>& others,
                                      std::uint64_t seed, const Context& context);

/// The sign of p at a rational number.
int sign_at(const UnivariatePolynomial& p, const Rational& x);

}  // namespace eliminant::symbolic
