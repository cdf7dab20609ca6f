// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/exceptional_points.hpp>

#include <algorithm>
#include <array>
#include <optional>

#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>
#include <eliminant/symbolic/elimination/common_component.hpp>
#include <eliminant/symbolic/elimination/factors.hpp>

namespace eliminant::symbolic {

namespace {

using Row = std::array<Integer, 4>;
using SymmetricMatrix = std::vector<std::vector<Rational>>;

/// Coefficients of a linear form with integer coefficients.
Row row_of(const Polynomial& form) {
  Row row;
  for (const auto& term : form.terms())
    for (std::size_t i = 0; i < 4; ++i)
      if (term.exponents[i] == 1) row[i] = term.coefficient.numerator();
  return row;
}

/// The factors of a witness that may vanish where w does not: linear ones as rows; nullopt for one of higher degree.
std::vector<std::optional<Row>> affine_factors(const Polynomial& witness) {
  std::vector<std::optional<Row>> result;
  for (const Polynomial& factor : irreducible_factors(witness)) {
    if (factor == Polynomial::variable(4, 3)) continue;
    result.push_back(factor.total_degree() == 1 ? std::optional(row_of(factor)) : std::nullopt);
  }
  return result;
}

/// A basis, in the columns, of the points on all planes.
IntegerMatrix common_points(const std::vector<Row>& planes) {
  IntegerMatrix system(static_cast<long>(planes.size()), 4);
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (long j = 0; j < 4; ++j)
      fmpz_set(system.entry(static_cast<long>(i), j), planes[i][static_cast<std::size_t>(j)].get());
  return nullspace(system);
}

/// Twice the quadratic form on combinations of the columns.
SymmetricMatrix restricted(const Polynomial& quadric, const IntegerMatrix& columns) {
  SymmetricMatrix twice(4, std::vector<Rational>(4));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) twice[i][j] = quadric.derivative(i).derivative(j).constant_term();
  const auto count = static_cast<std::size_t>(columns.columns());
  const auto entry = [&](std::size_t i, std::size_t k) {
    return Rational(Integer(columns.entry(static_cast<long>(i), static_cast<long>(k))));
  };
  SymmetricMatrix result(count, std::vector<Rational>(count));
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t l = 0; l < count; ++l)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) result[k][l] = result[k][l] + entry(i, k) * twice[i][j] * entry(j, l);
  return result;
}

/// The rank when the form is semidefinite, by symmetric elimination; nullopt when it has both signs.
std::optional<std::size_t> semidefinite_rank(SymmetricMatrix a) {
  const std::size_t n = a.size();
  std::vector<bool> done(n, false);
  int sign = 0;
  for (std::size_t rank = 0;; ++rank) {
    std::size_t pivot = n;
    for (std::size_t i = 0; i < n && pivot == n; ++i)
      if (!done[i] && !a[i][i].is_zero()) pivot = i;
    if (pivot == n) {
      // Without squares a product left over has both signs.
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          if (!done[i] && !done[j] && !a[i][j].is_zero()) return std::nullopt;
      return rank;
    }
    if (sign != 0 && a[pivot][pivot].sign() != sign) return std::nullopt;
    sign = a[pivot][pivot].sign();
    done[pivot] = true;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (!done[i] && !done[j]) a[i][j] = a[i][j] - a[i][pivot] * a[pivot][j] / a[pivot][pivot];
  }
}

/// The one point on the columns on which a semidefinite form of corank one vanishes.
Row kernel_point(const SymmetricMatrix& a, const IntegerMatrix& columns) {
  const auto count = columns.columns();
  // Entries are integers: twice a form with integer coefficients.
  IntegerMatrix system(count, count);
  for (long i = 0; i < count; ++i)
    for (long j = 0; j < count; ++j)
      fmpz_set(system.entry(i, j), a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].numerator().get());
  const IntegerMatrix kernel = nullspace(system);
  Row point;
  for (long i = 0; i < 4; ++i)
    for (long k = 0; k < count; ++k)
      point[static_cast<std::size_t>(i)] =
          point[static_cast<std::size_t>(i)] + Integer(columns.entry(i, k)) * Integer(kernel.entry(k, 0));
  return point;
}

/// Whether a line u = c or v = c of parameters, c rational or infinite, is mapped to the point.
bool is_image_of_line(const RationalSurface& surface, const Row& point) {
  const std::vector<Polynomial>& x = surface.coordinates();
  std::vector<Polynomial> conditions;
  for (std::size_t i = 0; i < 3; ++i) {
    const Polynomial condition = Rational(point[3]) * x[i] - Rational(point[i]) * x[3];
    if (!condition.is_zero()) conditions.push_back(condition);
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (std::all_of(conditions.begin(), conditions.end(),
                    [&](const Polynomial& p) { return p.degree(k) < surface.bidegree()[k]; }))
      return true;
  Polynomial common = conditions.front();
  for (const Polynomial& condition : conditions) common = split_common_component(common, condition).component;
  if (common.is_constant()) return false;
  const std::vector<Polynomial> factors = irreducible_factors(common);
  return std::any_of(factors.begin(), factors.end(), [](const Polynomial& p) {
    return p.total_degree() == 1 && (p.degree(0) == 0 || p.degree(1) == 0);
  });
}

/// The same for the points on some planes.
bool are_contracted_lines(const RationalSurface& surface, const Polynomial& equation, const std::vector<Row>& planes) {
  const IntegerMatrix columns = common_points(planes);
  if (columns.columns() == 0) return true;
  const SymmetricMatrix form = restricted(equation, columns);
  const std::optional<std::size_t> rank = semidefinite_rank(form);
  if (!rank || *rank + 1 < form.size()) return false;
  if (*rank == form.size()) return true;
  const Row point = kernel_point(form, columns);
  return point[3].is_zero() || is_image_of_line(surface, point);
}

}  // namespace

bool are_exceptions_contracted_lines(const RationalSurface& surface, const Polynomial& equation,
                                     const std::vector<Polynomial>& witnesses) {
  if (equation.total_degree() != 2) return false;
  // On every common zero of the witnesses a factor of each vanishes.
  std::vector<std::vector<Row>> choices(1);
  constexpr std::size_t most_choices = 64;
  for (const Polynomial& witness : witnesses) {
    std::vector<std::vector<Row>> next;
    for (const std::optional<Row>& factor : affine_factors(witness))
      for (const std::vector<Row>& planes : choices) {
        next.push_back(planes);
        if (factor) next.back().push_back(*factor);
      }
    if (next.size() > most_choices) return false;
    choices = std::move(next);
  }
  return std::all_of(choices.begin(), choices.end(),
                     [&](const auto& planes) { return are_contracted_lines(surface, equation, planes); });
}

}  // namespace eliminant::symbolic
