// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/geometry/bounding_box.hpp>

#include <algorithm>

#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::symbolic {

namespace {

/// The box around the points whose homogeneous coordinates these are, one list for each coordinate.
std::optional<BoundingBox> box_of(const std::vector<std::vector<Rational>>& coordinates) {
  const std::vector<Rational>& weights = coordinates.back();
  const int sign = weights.front().sign();
  if (sign == 0 || std::any_of(weights.begin(), weights.end(), [&](const Rational& w) { return w.sign() != sign; }))
    return std::nullopt;
  BoundingBox box;
  for (std::size_t k = 0; k + 1 < coordinates.size(); ++k) {
    const Rational first = coordinates[k].front() / weights.front();
    Interval& side = box.emplace_back(Interval{first, first});
    for (std::size_t i = 1; i < weights.size(); ++i) {
      const Rational value = coordinates[k][i] / weights[i];
      if (value < side.lower) side.lower = value;
      if (side.upper < value) side.upper = value;
    }
  }
  return box;
}

/// Coefficients of s^i t^j in row i.
std::vector<std::vector<Rational>> coefficient_rows(const Polynomial& p, const std::array<long, 2>& degrees) {
  std::vector<std::vector<Rational>> rows(static_cast<std::size_t>(degrees[0]) + 1,
                                          std::vector<Rational>(static_cast<std::size_t>(degrees[1]) + 1));
  for (const Polynomial::Term& term : p.terms()) rows[term.exponents[0]][term.exponents[1]] = term.coefficient;
  return rows;
}

/// One direction after the other.
std::vector<Rational> tensor_bernstein(std::vector<std::vector<Rational>> rows, const std::array<Interval, 2>& sides) {
  std::vector<Rational> result;
  for (std::vector<Rational>& row : rows) row = bernstein_coefficients(row, sides[1]);
  for (std::size_t j = 0; j < rows.front().size(); ++j) {
    std::vector<Rational> column;
    for (const std::vector<Rational>& row : rows) column.push_back(row[j]);
    for (Rational& value : bernstein_coefficients(column, sides[0])) result.push_back(std::move(value));
  }
  return result;
}

/// Of a form of degree d: the coefficients divided by d! / (i! j! k!).
std::vector<Rational> triangle_bernstein(const Polynomial& form, unsigned long degree) {
  std::vector<Rational> result(triangle_point_count(degree));
  for (const Polynomial::Term& term : form.terms()) {
    Integer first;
    Integer second;
    fmpz_bin_uiui(first.get(), degree, term.exponents[0]);
    fmpz_bin_uiui(second.get(), degree - term.exponents[0], term.exponents[1]);
    const unsigned long row = degree - term.exponents[0];
    result[row * (row + 1) / 2 + term.exponents[2]] = term.coefficient / Rational(first * second);
  }
  return result;
}

}  // namespace

std::optional<BoundingBox> bounding_box(const CurvePiece& piece) {
  if (!piece.domain) return std::nullopt;
  std::vector<std::vector<Rational>> coordinates;
  for (const UnivariatePolynomial& f : piece.map.coordinates()) {
    std::vector<Rational> coefficients;
    for (long k = 0; k <= piece.map.degree(); ++k) coefficients.emplace_back(f.coefficient(k));
    coordinates.push_back(bernstein_coefficients(coefficients, *piece.domain));
  }
  return box_of(coordinates);
}

std::optional<BoundingBox> bounding_box(const SurfacePiece& piece) {
  if (!piece.region) return std::nullopt;
  std::vector<std::vector<Rational>> coordinates;
  for (const Polynomial& f : piece.map.coordinates())
    coordinates.push_back(piece.region->triangle
                              ? triangle_bernstein(f, static_cast<unsigned long>(piece.map.degree()))
                              : tensor_bernstein(coefficient_rows(f, piece.map.bidegree()), piece.region->sides));
  return box_of(coordinates);
}

bool are_disjoint(const BoundingBox& a, const BoundingBox& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k].upper < b[k].lower || b[k].upper < a[k].lower) return true;
  return false;
}

}  // namespace eliminant::symbolic
