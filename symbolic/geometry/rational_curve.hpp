// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>
#include <eliminant/symbolic/geometry/domain.hpp>

namespace eliminant::symbolic {

/// A rational curve t -> (x : y : w) in the plane, or (x : y : z : w) in space: polynomials in Z[t] without a common
/// factor, not all zero. The largest of their degrees is the degree of the map, at t = infinity too.
class RationalCurve {
 public:
  /// Three or four coordinates, the weight last. A common factor, also one of the integers, is divided out.
  /// Throws InvalidInput when their number is another or all are zero.
  explicit RationalCurve(std::vector<UnivariatePolynomial> coordinates);

  /// 2 for a plane curve, 3 for a space curve.
  std::size_t dimension() const { return coordinates_.size() - 1; }
  long degree() const { return degree_; }
  const std::vector<UnivariatePolynomial>& coordinates() const { return coordinates_; }
  /// Coordinates at t = infinity: the coefficients of t^degree.
  std::vector<Integer> at_infinity() const;
  /// The homogeneous coordinates at t = value.
  std::vector<Rational> at(const Rational& value) const;

 private:
  std::vector<UnivariatePolynomial> coordinates_;
  long degree_ = 0;
};

/// The curve whose coordinates have these coefficients, in ascending order; common denominators are cleared.
/// Throws as the constructor of RationalCurve.
RationalCurve rational_curve(const std::vector<std::vector<Rational>>& coefficients);

/// The curve with these coordinates in Q[t], polynomials in one variable.
/// Throws as the constructor of RationalCurve, and InvalidInput when a polynomial has more variables.
RationalCurve rational_curve(const std::vector<Polynomial>& coordinates);

/// A map and the part of its parameter line that counts: without a domain the whole projective line.
struct CurvePiece {
  RationalCurve map;
  std::optional<Interval> domain;
};

/// A curve as handed in: pieces in one parameter, whose domains meet at their ends (NURBS), or one piece.
struct ParametricCurve {
  std::vector<CurvePiece> pieces;
};

}  // namespace eliminant::symbolic
