// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/intersect/curves/curve_problems.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/plane_curves/parameter_roots.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>

/// What the tests of curves against curves and surfaces share.
namespace eliminant::test {

using symbolic::Polynomial;
using symbolic::Rational;

/// Small integers, the same on every platform.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [low, high].
  long between(long low, long high) {
    return low + static_cast<long>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 engine_;
};

/// 2^exponent.
inline Rational power_of_two(long exponent) {
  Rational value(1);
  for (long k = 0; k < exponent; ++k) value = value * Rational(2);
  for (long k = 0; k > exponent; --k) value = value / Rational(2);
  return value;
}

/// A polynomial in t.
inline Polynomial in_t(std::string_view text) {
  static const std::vector<std::string> names{"t"};
  return symbolic::parse_polynomial(text, names);
}

inline Polynomial t_variable() { return Polynomial::variable(1, 0); }
inline Polynomial t_constant(const Rational& value) { return Polynomial::constant(1, value); }

inline Rational value_at(const Polynomial& p, const std::vector<Rational>& point) {
  std::vector<Polynomial> images;
  for (const Rational& coordinate : point) images.push_back(Polynomial::constant(1, coordinate));
  return p.compose(images).constant_term();
}

using Domain = std::optional<symbolic::Interval>;

inline symbolic::ParametricCurve map_of(const std::vector<Polynomial>& coordinates, const Domain& domain = {}) {
  return {{{symbolic::rational_curve(coordinates), domain}}};
}

inline symbolic::ParametricCurve map_of(std::initializer_list<const char*> coordinates, const Domain& domain = {}) {
  std::vector<Polynomial> parsed;
  for (const char* text : coordinates) parsed.push_back(in_t(text));
  return map_of(parsed, domain);
}

/// Every coordinate with another parameter.
inline std::vector<Polynomial> reparametrized(const std::vector<Polynomial>& coordinates, const Polynomial& parameter) {
  std::vector<Polynomial> result;
  const std::vector<Polynomial> images{parameter};
  for (const Polynomial& f : coordinates) result.push_back(f.compose(images));
  return result;
}

inline std::vector<Polynomial> reversed(const std::vector<Polynomial>& coordinates) {
  return reparametrized(coordinates, t_constant(1) - t_variable());
}

/// The point moved by an affine map that is far from the identity.
inline std::vector<Polynomial> moved(std::vector<Polynomial> coordinates, const Rational& scale,
                                     const Rational& shift) {
  const Polynomial weight = coordinates.back();
  for (std::size_t k = 0; k + 1 < coordinates.size(); ++k)
    coordinates[k] = scale * coordinates[k] + (k % 2 == 0 ? shift : -shift) * weight;
  return coordinates;
}

inline Polynomial random_in_t(Draw& draw, long degree, long size) {
  std::vector<Polynomial::Term> terms;
  for (long i = 0; i <= degree; ++i)
    terms.push_back({Rational(draw.between(-size, size)), {static_cast<unsigned long>(i)}});
  return Polynomial::from_terms(1, terms);
}

inline Rational determinant(const std::vector<std::vector<Rational>>& rows) {
  if (rows.size() == 1) return rows[0][0];
  Rational sum(0);
  for (std::size_t j = 0; j < rows.size(); ++j) {
    std::vector<std::vector<Rational>> minor;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      minor.emplace_back();
      for (std::size_t k = 0; k < rows.size(); ++k)
        if (k != j) minor.back().push_back(rows[i][k]);
    }
    const Rational term = rows[0][j] * determinant(minor);
    sum = j % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

inline bool is_infinite(const std::optional<intersect::Parameter>& parameter) { return parameter && !*parameter; }

/// Finite, this number within the enclosure, and printed no further from it than the radius says.
inline bool is_value(const intersect::Parameter& parameter, const Rational& value, long radius_exponent) {
  if (!parameter || acb_contains_fmpq(parameter->ball.get(), value.get()) == 0) return false;
  const Rational difference = symbolic::parse_number(parameter->real) - value;
  const Rational radius = symbolic::parse_number("1e" + std::to_string(radius_exponent));
  return parameter->imaginary == "0" && !(radius < difference) && !(difference < -radius);
}

inline bool is_t(const intersect::CurveSolution& solution, const Rational& value) {
  return solution.t && is_value(*solution.t, value, solution.radius_exponent);
}

inline bool is_u(const intersect::CurveSolution& solution, const Rational& value) {
  return solution.u && is_value(*solution.u, value, solution.radius_exponent);
}

/// Whether two parameters can be the same.
inline bool may_agree(const std::optional<intersect::Parameter>& a, const std::optional<intersect::Parameter>& b) {
  if (!a || !b) return !a && !b;
  if (!*a || !*b) return !*a && !*b;
  return acb_overlaps((*a)->ball.get(), (*b)->ball.get()) != 0;
}

/// The parameter in 1 - t.
inline std::optional<intersect::Parameter> reversed(std::optional<intersect::Parameter> parameter) {
  if (!parameter || !*parameter) return parameter;
  acb_sub_ui((*parameter)->ball.get(), (*parameter)->ball.get(), 1, 1000);
  acb_neg((*parameter)->ball.get(), (*parameter)->ball.get());
  return parameter;
}

constexpr long check_bits = 400;

inline std::vector<bridge::ComplexBall> point_at(const symbolic::RationalCurve& map,
                                                 const intersect::Parameter& parameter) {
  std::vector<bridge::ComplexBall> point;
  if (parameter) {
    for (const auto& f : map.coordinates()) point.push_back(intersect::evaluate(f, parameter->ball, check_bits));
  } else {
    for (const auto& coordinate : map.at_infinity()) acb_set_fmpz(point.emplace_back().get(), coordinate.get());
  }
  return point;
}

/// Whether homogeneous coordinates can belong to one point.
inline bool may_be_same_point(const std::vector<bridge::ComplexBall>& a, const std::vector<bridge::ComplexBall>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      bridge::ComplexBall minor;
      acb_mul(minor.get(), a[i].get(), b[j].get(), check_bits);
      acb_submul(minor.get(), a[j].get(), b[i].get(), check_bits);
      if (acb_contains_zero(minor.get()) == 0) return false;
    }
  return true;
}

inline std::vector<bridge::ComplexBall> balls(const std::vector<intersect::Coordinate>& coordinates) {
  std::vector<bridge::ComplexBall> result;
  for (const intersect::Coordinate& coordinate : coordinates) result.push_back(coordinate.ball);
  return result;
}

/// The audit of a list of all complex solutions: what is listed adds up to what Bezout's theorem says.
inline bool complete_audit_holds(const intersect::CurveResult& result, unsigned long expected) {
  unsigned long with_multiplicity = 0;
  unsigned long real = 0;
  bool certified = true;
  for (const intersect::CurveSolution& solution : result.solutions) {
    with_multiplicity += solution.multiplicity;
    if (solution.reality == intersect::Reality::real) ++real;
    certified = certified && solution.certified;
  }
  const intersect::CurveCounts& counts = result.counts;
  return result.status == intersect::Status::certified && certified && with_multiplicity == expected &&
         counts.with_multiplicity == expected && counts.expected == expected &&
         counts.distinct == result.solutions.size() && counts.listed == result.solutions.size() &&
         counts.real == real && counts.undecided == 0;
}

/// Curves of two to four segments and parabolas with corners on a small grid, one corner common to all of one object:
/// seams on seams, seams inside pieces, overlaps that end anywhere, closed curves.
class CornerCurves {
 public:
  CornerCurves(Draw& draw, std::size_t dimension) : draw_(draw), dimension_(dimension), common_(corner()) {}

  symbolic::ParametricCurve next() {
    const long count = draw_.between(2, 4);
    std::vector<Corner> corners;
    for (long k = 0; k <= count; ++k) corners.push_back(corner());
    corners[static_cast<std::size_t>(draw_.between(1, count - 1))] = common_;
    if (draw_.between(0, 2) == 0) corners.back() = corners.front();
    symbolic::ParametricCurve result;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      // A piece must not be a point.
      while (corners[k + 1] == corners[k]) {
        const bool movable = k + 2 == corners.size() || !(corners[k + 1] == common_);
        corners[movable ? k + 1 : k] = corner();
      }
      const Corner middle = corner();
      const bool straight = draw_.between(0, 3) > 0;
      result.pieces.push_back(piece(corners[k], middle, corners[k + 1], straight, static_cast<long>(k)));
    }
    return result;
  }

 private:
  using Corner = std::array<long, 3>;

  /// In space two heights are enough to meet often.
  Corner corner() {
    const long x = draw_.between(0, 2);
    const long y = draw_.between(0, 2);
    return {x, y, dimension_ == 3 ? draw_.between(0, 1) : 0};
  }

  symbolic::CurvePiece piece(const Corner& from, const Corner& middle, const Corner& to, bool straight,
                             long begin) const {
    const Polynomial s = t_variable() - t_constant(begin);
    const Polynomial r = t_constant(1) - s;
    std::vector<Polynomial> map;
    for (std::size_t k = 0; k < dimension_; ++k)
      map.push_back(straight
                        ? t_constant(from[k]) * r + t_constant(to[k]) * s
                        : t_constant(from[k]) * r * r + t_constant(2 * middle[k]) * r * s + t_constant(to[k]) * s * s);
    map.push_back(t_constant(1));
    return map_of(map, symbolic::Interval{begin, begin + 1}).pieces[0];
  }

  Draw& draw_;
  std::size_t dimension_;
  Corner common_;
};

}  // namespace eliminant::test
