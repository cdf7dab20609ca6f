// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/matrices/bezoutian_matrix.hpp>

#include <algorithm>
#include <map>

#include <eliminant/base/error.hpp>

namespace eliminant::symbolic {

namespace {

/// Determinants of the minors of the first columns, one column after the other: for each set of rows the minor.
Polynomial expanded_determinant(const std::vector<std::vector<Polynomial>>& rows, std::size_t variable_count) {
  const std::size_t size = rows.size();
  std::map<std::size_t, Polynomial> minors;
  minors.emplace(0, Polynomial::constant(variable_count, 1));
  for (std::size_t column = 0; column < size; ++column) {
    std::map<std::size_t, Polynomial> next;
    for (const auto& [set, minor] : minors) {
      // The new row stands behind `below` rows of the set: the sign of the last column of a minor.
      for (std::size_t row = 0; row < size; ++row) {
        const std::size_t bit = std::size_t{1} << row;
        if ((set & bit) != 0 || rows[row][column].is_zero()) continue;
        std::size_t after = 0;
        for (std::size_t k = row + 1; k < size; ++k) after += (set >> k) & 1U;
        const Polynomial product = Rational(after % 2 == 0 ? 1 : -1) * (minor * rows[row][column]);
        const auto [place, inserted] = next.try_emplace(set | bit, product);
        if (!inserted) place->second = place->second + product;
      }
    }
    minors = std::move(next);
  }
  const auto whole = minors.find((std::size_t{1} << size) - 1);
  return whole == minors.end() ? Polynomial(variable_count) : whole->second;
}

/// (f(.., x_i, ..) - f(.., y, ..)) / (x_i - y), term by term: x^(e-1) + x^(e-2) y + ... + y^(e-1) for x^e.
Polynomial divided_difference(const Polynomial& f, std::size_t x, std::size_t y) {
  std::vector<Polynomial::Term> terms;
  for (const Polynomial::Term& term : f.terms())
    for (unsigned long k = 0; k < term.exponents[x]; ++k) {
      Polynomial::Term& added = terms.emplace_back(term);
      added.exponents[x] = k;
      added.exponents[y] += term.exponents[x] - 1 - k;
    }
  return Polynomial::from_terms(f.variable_count(), terms);
}

/// f with y in place of x, in a ring where f does not contain y.
Polynomial renamed(const Polynomial& f, std::size_t x, std::size_t y) {
  std::vector<Polynomial::Term> terms = f.terms();
  for (Polynomial::Term& term : terms) std::swap(term.exponents[x], term.exponents[y]);
  return Polynomial::from_terms(f.variable_count(), terms);
}

Polynomial in_larger_ring(const Polynomial& f, std::size_t variable_count) {
  std::vector<Polynomial::Term> terms = f.terms();
  for (Polynomial::Term& term : terms) term.exponents.resize(variable_count, 0);
  return Polynomial::from_terms(variable_count, terms);
}

Polynomial bracket(const std::array<Polynomial, 4>& a, const std::array<Polynomial, 4>& b,
                   const std::array<Polynomial, 4>& c, const std::array<Polynomial, 4>& d) {
  const auto minor = [](const auto& p, const auto& q, std::size_t i, std::size_t j) {
    return p[i] * q[j] - p[j] * q[i];
  };
  return minor(a, b, 0, 1) * minor(c, d, 2, 3) - minor(a, b, 0, 2) * minor(c, d, 1, 3) +
         minor(a, b, 0, 3) * minor(c, d, 1, 2) + minor(a, b, 1, 2) * minor(c, d, 0, 3) -
         minor(a, b, 1, 3) * minor(c, d, 0, 2) + minor(a, b, 2, 3) * minor(c, d, 0, 1);
}

/// The terms of p by their degree in variable `index`, in two variables: `index` is removed and the other one becomes
/// variable `kept`.
std::vector<Polynomial> coefficients(const Polynomial& p, std::size_t index, long degree, std::size_t kept) {
  std::vector<std::vector<Polynomial::Term>> parts(static_cast<std::size_t>(degree) + 1);
  for (const Polynomial::Term& term : p.terms()) {
    std::vector<unsigned long> exponents(2, 0);
    exponents[kept] = term.exponents[1 - index];
    parts[term.exponents[index]].push_back({term.coefficient, std::move(exponents)});
  }
  std::vector<Polynomial> result;
  for (const auto& part : parts) result.push_back(Polynomial::from_terms(2, part));
  return result;
}

void require_tensor_product(const RationalSurface& surface) {
  if (surface.kind() != RationalSurface::Kind::tensor_product)
    throw InvalidInput("the Bezoutian matrix of a surface over a triangle was asked for",
                       "a surface with two affine parameters");
}

void require_degree(long degree, const char* parameter) {
  if (degree < 1)
    throw InvalidInput(std::string("a surface does not depend on its ") + parameter + " parameter: it is a curve",
                       "a surface");
}

/// The coefficient vectors of powers of variable `index`, weight first, over the ring where the other one is variable
/// `kept`.
CoefficientVectors coefficient_vectors(const RationalSurface& surface, std::size_t index, std::size_t kept) {
  const long degree = surface.bidegree()[index];
  CoefficientVectors result(static_cast<std::size_t>(degree) + 1,
                            {Polynomial(2), Polynomial(2), Polynomial(2), Polynomial(2)});
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<Polynomial> parts = coefficients(surface.coordinates()[(k + 3) % 4], index, degree, kept);
    for (std::size_t e = 0; e < parts.size(); ++e) result[e][k] = std::move(parts[e]);
  }
  return result;
}

/// The Taylor coefficients of the surface in variable `index`: [h^e] of the coordinates with x_index + h in its place.
CoefficientVectors taylor_vectors(const RationalSurface& surface, std::size_t index) {
  const auto degree = static_cast<std::size_t>(surface.bidegree()[index]);
  CoefficientVectors result(degree + 1, {Polynomial(2), Polynomial(2), Polynomial(2), Polynomial(2)});
  for (std::size_t k = 0; k < 4; ++k) {
    Polynomial derivative = surface.coordinates()[(k + 3) % 4];
    for (std::size_t e = 0; e <= degree; ++e) {
      result[e][k] = derivative;
      derivative = Rational(1) / Rational(static_cast<long>(e) + 1) * derivative.derivative(index);
    }
  }
  return result;
}

BezoutianMatrix without_first(const BezoutianMatrix& matrix) {
  std::vector<BezoutianMatrix::Monomial> monomials(matrix.row_monomials().begin() + 1, matrix.row_monomials().end());
  std::vector<Polynomial> entries;
  for (std::size_t i = 1; i < matrix.rows(); ++i)
    for (std::size_t j = 1; j < matrix.columns(); ++j) entries.push_back(matrix.entry(i, j));
  return {monomials, monomials, std::move(entries)};
}

}  // namespace

BezoutianMatrix::BezoutianMatrix(std::vector<Monomial> row_monomials, std::vector<Monomial> column_monomials,
                                 std::vector<Polynomial> entries)
    : row_monomials_(std::move(row_monomials)),
      column_monomials_(std::move(column_monomials)),
      entries_(std::move(entries)) {
  if (entries_.size() != rows() * columns())
    throw InvalidInput("a matrix of " + std::to_string(rows()) + " rows and " + std::to_string(columns()) +
                           " columns was given " + std::to_string(entries_.size()) + " entries",
                       std::to_string(rows() * columns()) + " entries");
}

bool BezoutianMatrix::is_symmetric() const {
  if (row_monomials_ != column_monomials_) return false;
  for (std::size_t i = 0; i < rows(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!(entry(i, j) == entry(j, i))) return false;
  return true;
}

BezoutianMatrix bezoutian_matrix(std::span<const Polynomial> polynomials, std::span<const std::size_t> eliminated) {
  const std::size_t n = eliminated.size();
  if (polynomials.size() != n + 1)
    throw InvalidInput("the Bezoutian of " + std::to_string(polynomials.size()) + " polynomials in " +
                           std::to_string(n) + " variables was asked for",
                       std::to_string(n + 1) + " polynomials");
  const std::size_t variables = polynomials.front().variable_count();
  std::vector<bool> chosen(variables, false);
  for (const std::size_t index : eliminated) {
    if (index >= variables || chosen[index])
      throw InvalidInput("the eliminated variables of a Bezoutian are not different variables of its polynomials",
                         "different indices below " + std::to_string(variables));
    chosen[index] = true;
  }
  // Variable eliminated[i] is x_i; y_i is appended to the ring.
  std::vector<std::vector<Polynomial>> rows;
  for (const Polynomial& f : polynomials) {
    Polynomial partly = in_larger_ring(f, variables + n);
    std::vector<Polynomial>& row = rows.emplace_back();
    row.push_back(partly);
    for (std::size_t i = 0; i < n; ++i) {
      row.push_back(divided_difference(partly, eliminated[i], variables + i));
      partly = renamed(partly, eliminated[i], variables + i);
    }
  }
  using Key = std::pair<BezoutianMatrix::Monomial, BezoutianMatrix::Monomial>;
  std::map<Key, std::vector<Polynomial::Term>> parts;
  std::map<BezoutianMatrix::Monomial, std::size_t> row_places;
  std::map<BezoutianMatrix::Monomial, std::size_t> column_places;
  for (Polynomial::Term& term : expanded_determinant(rows, variables + n).terms()) {
    BezoutianMatrix::Monomial x;
    BezoutianMatrix::Monomial y(term.exponents.begin() + static_cast<std::ptrdiff_t>(variables), term.exponents.end());
    for (const std::size_t index : eliminated) x.push_back(std::exchange(term.exponents[index], 0));
    term.exponents.resize(variables);
    row_places.try_emplace(y, 0);
    column_places.try_emplace(x, 0);
    parts[{y, x}].push_back(std::move(term));
  }
  const auto monomials_of = [](auto& places) {
    std::vector<BezoutianMatrix::Monomial> monomials;
    for (auto& [monomial, place] : places) {
      place = monomials.size();
      monomials.push_back(monomial);
    }
    return monomials;
  };
  std::vector<BezoutianMatrix::Monomial> row_monomials = monomials_of(row_places);
  std::vector<BezoutianMatrix::Monomial> column_monomials = monomials_of(column_places);
  std::vector<Polynomial> entries(row_monomials.size() * column_monomials.size(), Polynomial(variables));
  for (const auto& [key, terms] : parts)
    entries[row_places[key.first] * column_monomials.size() + column_places[key.second]] =
        Polynomial::from_terms(variables, terms);
  return {std::move(row_monomials), std::move(column_monomials), std::move(entries)};
}

BezoutianMatrix separated_bezoutian_matrix(const CoefficientVectors& first, const CoefficientVectors& second) {
  if (first.empty() || second.empty())
    throw InvalidInput("the Bezoutian matrix of a curve without coefficients was asked for", "two curves");
  const std::size_t n = first.size() - 1;
  const std::size_t m = second.size() - 1;
  std::vector<BezoutianMatrix::Monomial> monomials;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) monomials.push_back({i, j});
  std::vector<Polynomial> entries;
  for (const auto& row : monomials)
    for (const auto& column : monomials) {
      const std::size_t s_power = row[0] + column[0] + 1;
      const std::size_t v_power = row[1] + column[1] + 1;
      Polynomial sum(first.front().front().variable_count());
      for (std::size_t p = v_power > n ? v_power - n : 0; p <= std::min(row[1], column[1]); ++p)
        for (std::size_t r = s_power > m ? s_power - m : 0; r <= std::min(row[0], column[0]); ++r)
          sum = sum + bracket(first[p], first[v_power - p], second[r], second[s_power - r]);
      entries.push_back(std::move(sum));
    }
  return {monomials, monomials, std::move(entries)};
}

BezoutianMatrix intersection_bezoutian_matrix(const RationalSurface& first, const RationalSurface& second) {
  require_tensor_product(first);
  require_tensor_product(second);
  require_degree(first.bidegree()[1], "second");
  require_degree(second.bidegree()[0], "first");
  return separated_bezoutian_matrix(coefficient_vectors(first, 1, 0), coefficient_vectors(second, 0, 1));
}

BezoutianMatrix self_intersection_bezoutian_matrix(const RationalSurface& surface) {
  require_tensor_product(surface);
  require_degree(surface.bidegree()[0], "first");
  require_degree(surface.bidegree()[1], "second");
  return without_first(separated_bezoutian_matrix(taylor_vectors(surface, 1), taylor_vectors(surface, 0)));
}

Polynomial determinant(const BezoutianMatrix& matrix) {
  if (matrix.rows() != matrix.columns())
    throw InvalidInput("the determinant of a " + std::to_string(matrix.rows()) + " x " +
                           std::to_string(matrix.columns()) + " matrix was asked for",
                       "a square matrix");
  if (matrix.rows() == 0) return Polynomial::constant(2, 1);
  std::vector<std::vector<Polynomial>> rows(matrix.rows());
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) rows[i].push_back(matrix.entry(i, j));
  return expanded_determinant(rows, matrix.entry(0, 0).variable_count());
}

}  // namespace eliminant::symbolic
