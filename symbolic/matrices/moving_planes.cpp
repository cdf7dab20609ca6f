// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/matrices/moving_planes.hpp>

#include <algorithm>
#include <map>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/modular_matrix.hpp>

namespace eliminant::symbolic {

namespace {

using Exponents = std::vector<unsigned long>;
using Monomials = std::vector<Exponents>;

/// s^i t^j u^k of degree nu: by decreasing i, then decreasing j.
Monomials ternary_monomials(long nu) {
  Monomials monomials;
  for (long i = nu; i >= 0; --i)
    for (long j = nu - i; j >= 0; --j)
      monomials.push_back(
          {static_cast<unsigned long>(i), static_cast<unsigned long>(j), static_cast<unsigned long>(nu - i - j)});
  return monomials;
}

/// s^i t^j, i <= nu[0], j <= nu[1]: by i, then j.
Monomials tensor_monomials(std::array<long, 2> nu) {
  Monomials monomials;
  for (long i = 0; i <= nu[0]; ++i)
    for (long j = 0; j <= nu[1]; ++j)
      monomials.push_back({static_cast<unsigned long>(i), static_cast<unsigned long>(j)});
  return monomials;
}

std::map<Exponents, long> positions(const Monomials& monomials) {
  std::map<Exponents, long> result;
  for (std::size_t i = 0; i < monomials.size(); ++i) result[monomials[i]] = static_cast<long>(i);
  return result;
}

Exponents product(const Exponents& a, const Exponents& b) {
  Exponents result = a;
  for (std::size_t k = 0; k < a.size(); ++k) result[k] += b[k];
  return result;
}

/// The equations of the syzygies sum over k of a_k f_k = 0 with a_k in the span of `rows`, so that the products are in
/// that of `products`.
IntegerMatrix syzygy_system(const RationalSurface& surface, const Monomials& rows, const Monomials& products) {
  const std::map<Exponents, long> equations = positions(products);
  const auto count = static_cast<long>(rows.size());
  IntegerMatrix system(static_cast<long>(products.size()), 4 * count);
  for (long k = 0; k < 4; ++k)
    for (const Polynomial::Term& term : surface.coordinates()[static_cast<std::size_t>(k)].terms())
      for (long row = 0; row < count; ++row)
        fmpz_set(
            system.entry(equations.at(product(term.exponents, rows[static_cast<std::size_t>(row)])), k * count + row),
            term.coefficient.numerator().get());
  return system;
}

MatrixRepresentation from_syzygies(const RationalSurface& surface, Monomials rows, const Monomials& products) {
  const IntegerMatrix planes = nullspace(syzygy_system(surface, rows, products));
  const auto count = static_cast<long>(rows.size());
  MatrixRepresentation result;
  result.row_monomials = std::move(rows);
  for (long k = 0; k < 4; ++k) {
    IntegerMatrix& coefficients = result.coefficients.emplace_back(count, planes.columns());
    for (long i = 0; i < count; ++i)
      for (long j = 0; j < planes.columns(); ++j) fmpz_set(coefficients.entry(i, j), planes.entry(k * count + i, j));
  }
  return result;
}

}  // namespace

MatrixRepresentation moving_plane_matrix(const RationalSurface& surface, long nu) {
  if (surface.kind() != RationalSurface::Kind::triangular)
    throw InvalidInput("one degree was given for moving planes of a tensor-product surface", "two degrees");
  if (nu < 0) throw InvalidInput("the degree of moving planes is " + std::to_string(nu), "at least 0");
  return from_syzygies(surface, ternary_monomials(nu), ternary_monomials(nu + surface.degree()));
}

MatrixRepresentation moving_plane_matrix(const RationalSurface& surface, std::array<long, 2> nu) {
  if (surface.kind() != RationalSurface::Kind::tensor_product)
    throw InvalidInput("two degrees were given for moving planes of a surface over the projective plane", "one degree");
  if (nu[0] < 0 || nu[1] < 0) throw InvalidInput("a degree of moving planes is negative", "at least 0");
  const std::array<long, 2> degrees = surface.bidegree();
  return from_syzygies(surface, tensor_monomials(nu), tensor_monomials({nu[0] + degrees[0], nu[1] + degrees[1]}));
}

IntegerMatrix moving_plane_system(const RationalSurface& surface, std::array<long, 2> nu) {
  if (surface.kind() != RationalSurface::Kind::tensor_product)
    throw InvalidInput("two degrees were given for moving planes of a surface over the projective plane", "one degree");
  const std::array<long, 2> degrees = surface.bidegree();
  return syzygy_system(surface, tensor_monomials(nu), tensor_monomials({nu[0] + degrees[0], nu[1] + degrees[1]}));
}

long representation_degree(const RationalSurface& surface, std::uint64_t seed) {
  const long d = surface.degree();
  const long lowest = std::max(d - 1, 0L);
  // In degree 3 d - 2 and above the base ideal, whose zeros are points, is its own saturation.
  const long high = 3 * d - 2;
  if (d < 2) return lowest;
  const PrimeField field(PrimeSequence(seed).next());
  const Monomials all = ternary_monomials(high);
  const std::map<Exponents, long> position = positions(all);
  const Monomials multipliers = ternary_monomials(high - d);
  ModularMatrix ideal(static_cast<long>(4 * multipliers.size()), static_cast<long>(all.size()), field);
  long row = 0;
  for (const Polynomial& f : surface.coordinates()) {
    const std::vector<Polynomial::Term> terms = f.terms();
    for (const Exponents& multiplier : multipliers) {
      for (const Polynomial::Term& term : terms)
        ideal(row, position.at(product(term.exponents, multiplier))) = field.reduce(term.coefficient.numerator());
      ++row;
    }
  }
  const long rank = nmod_mat_rref(ideal.get());
  const long base_points = static_cast<long>(all.size()) - rank;
  if (base_points == 0) return std::max(lowest, 2 * (d - 1));
  // The image of a monomial in the quotient by the ideal: itself, or minus the free part of the row it is the pivot of.
  std::vector<long> free_index(all.size(), -1);
  std::vector<long> pivot_row(all.size(), -1);
  long next_row = 0;
  long next_free = 0;
  for (long j = 0; j < static_cast<long>(all.size()); ++j) {
    if (next_row < rank && ideal(next_row, j) != 0)
      pivot_row[static_cast<std::size_t>(j)] = next_row++;
    else
      free_index[static_cast<std::size_t>(j)] = next_free++;
  }
  for (long k = 1; k < d; ++k) {
    // Forms h of degree k with h m in the ideal for every monomial m of degree high - k.
    const Monomials forms = ternary_monomials(k);
    const Monomials complements = ternary_monomials(high - k);
    ModularMatrix conditions(static_cast<long>(complements.size()) * base_points, static_cast<long>(forms.size()),
                             field);
    for (std::size_t m = 0; m < complements.size(); ++m)
      for (std::size_t h = 0; h < forms.size(); ++h) {
        const long column = position.at(product(complements[m], forms[h]));
        const long first = static_cast<long>(m) * base_points;
        const long own = free_index[static_cast<std::size_t>(column)];
        if (own >= 0) {
          conditions(first + own, static_cast<long>(h)) = 1;
          continue;
        }
        for (std::size_t j = 0; j < all.size(); ++j)
          if (free_index[j] >= 0)
            conditions(first + free_index[j], static_cast<long>(h)) =
                field.negate(ideal(pivot_row[static_cast<std::size_t>(column)], static_cast<long>(j)));
      }
    if (nmod_mat_rank(conditions.get()) < static_cast<long>(forms.size())) return std::max(lowest, 2 * (d - 1) - k);
  }
  return std::max(lowest, d - 2);
}

std::array<long, 2> representation_bidegree(const RationalSurface& surface) {
  const auto [m, n] = surface.bidegree();
  const std::array<long, 2> first{2 * m - 1, n - 1};
  const std::array<long, 2> second{m - 1, 2 * n - 1};
  return std::min(first[0], first[1]) >= std::min(second[0], second[1]) ? first : second;
}

MatrixRepresentation matrix_representation(const RationalSurface& surface) {
  return surface.kind() == RationalSurface::Kind::triangular
             ? moving_plane_matrix(surface, representation_degree(surface))
             : moving_plane_matrix(surface, representation_bidegree(surface));
}

}  // namespace eliminant::symbolic
