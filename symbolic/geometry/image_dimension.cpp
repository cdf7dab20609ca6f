// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/geometry/image_dimension.hpp>

#include <array>

namespace eliminant::symbolic {

namespace {

template <class Number>
using Columns = std::array<std::vector<Number>, 3>;

// The minor of the rows other than `omitted`.
template <class Number>
Number minor_without(std::size_t omitted, const Columns<Number>& columns) {
  std::array<std::size_t, 3> rows{};
  for (std::size_t row = 0, next = 0; row < 4; ++row)
    if (row != omitted) rows[next++] = row;
  const auto at = [&](std::size_t row, std::size_t column) -> const Number& { return columns[column][rows[row]]; };
  const auto cofactor = [&](std::size_t a, std::size_t b) { return at(1, a) * at(2, b) - at(1, b) * at(2, a); };
  return at(0, 0) * cofactor(1, 2) - at(0, 1) * cofactor(0, 2) + at(0, 2) * cofactor(0, 1);
}

template <class Number>
bool has_rank_three(const Columns<Number>& columns) {
  for (std::size_t omitted = 0; omitted < 4; ++omitted)
    if (!minor_without(omitted, columns).is_zero()) return true;
  return false;
}

Rational value_at(const Polynomial& p, const std::vector<Rational>& point) {
  Rational sum;
  for (const Polynomial::Term& term : p.terms()) {
    Rational product = term.coefficient;
    for (std::size_t i = 0; i < point.size(); ++i) {
      Rational factor;
      fmpq_pow_si(factor.get(), point[i].get(), static_cast<slong>(term.exponents[i]));
      product = product * factor;
    }
    sum = sum + product;
  }
  return sum;
}

}  // namespace

bool is_two_dimensional(const RationalSurface& surface) {
  const bool forms = surface.kind() == RationalSurface::Kind::triangular;
  Columns<Polynomial> columns;
  for (const Polynomial& coordinate : surface.coordinates()) {
    // Of forms, the three derivatives span the coordinates, too (Euler's relation).
    columns[0].push_back(forms ? coordinate.derivative(2) : coordinate);
    columns[1].push_back(coordinate.derivative(0));
    columns[2].push_back(coordinate.derivative(1));
  }
  for (const auto& [a, b] : {std::array{2, 3}, {-3, 5}, {7, -2}}) {
    std::vector<Rational> point{a, b};
    if (forms) point.emplace_back(1);
    Columns<Rational> values;
    for (std::size_t i = 0; i < 3; ++i)
      for (const Polynomial& entry : columns[i]) values[i].push_back(value_at(entry, point));
    if (has_rank_three(values)) return true;
  }
  return has_rank_three(columns);
}

}  // namespace eliminant::symbolic
