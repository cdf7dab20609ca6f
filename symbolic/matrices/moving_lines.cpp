// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/matrices/moving_lines.hpp>

namespace eliminant::symbolic {

namespace {

/// The moving lines of degree nu: a basis of the solutions of sum over k of a_k f_k = 0, the coefficient of t^j in a_k
/// in row k (nu + 1) + j.
IntegerMatrix syzygies(const RationalCurve& curve, long nu) {
  const auto count = static_cast<long>(curve.coordinates().size());
  IntegerMatrix system(curve.degree() + nu + 1, count * (nu + 1));
  for (long k = 0; k < count; ++k) {
    const UnivariatePolynomial& f = curve.coordinates()[static_cast<std::size_t>(k)];
    for (long j = 0; j <= nu; ++j)
      for (long i = 0; i <= f.degree(); ++i)
        fmpz_poly_get_coeff_fmpz(system.entry(i + j, k * (nu + 1) + j), f.get(), i);
  }
  return nullspace(system);
}

MovingLine moving_line(const IntegerMatrix& syzygies, long column, std::size_t count, long nu) {
  MovingLine line(count);
  for (std::size_t k = 0; k < count; ++k)
    for (long j = 0; j <= nu; ++j)
      fmpz_poly_set_coeff_fmpz(line[k].get(), j, syzygies.entry(static_cast<long>(k) * (nu + 1) + j, column));
  return line;
}

/// The coefficients of t^shift times the line, as a column of `matrix`.
void set_column(IntegerMatrix& matrix, long column, const MovingLine& line, long shift, long nu) {
  for (std::size_t k = 0; k < line.size(); ++k)
    for (long j = 0; j <= line[k].degree(); ++j)
      fmpz_poly_get_coeff_fmpz(matrix.entry(static_cast<long>(k) * (nu + 1) + j + shift, column), line[k].get(), j);
}

}  // namespace

std::vector<MovingLine> moving_line_basis(const RationalCurve& curve) {
  const std::size_t count = curve.coordinates().size();
  struct Generator {
    MovingLine line;
    long degree;
  };
  std::vector<Generator> generators;
  for (long nu = 0; generators.size() + 1 < count; ++nu) {
    const IntegerMatrix candidates = syzygies(curve, nu);
    // The multiples of the generators so far, and then every candidate that is independent of them.
    long known = 0;
    for (const Generator& generator : generators) known += nu - generator.degree + 1;
    IntegerMatrix multiples(static_cast<long>(count) * (nu + 1), known);
    long column = 0;
    for (const Generator& generator : generators)
      for (long shift = 0; shift <= nu - generator.degree; ++shift)
        set_column(multiples, column++, generator.line, shift, nu);
    for (long c = 0; c < candidates.columns() && known < candidates.columns() && generators.size() + 1 < count; ++c) {
      const MovingLine line = moving_line(candidates, c, count, nu);
      IntegerMatrix extended(multiples.rows(), multiples.columns() + 1);
      for (long i = 0; i < multiples.rows(); ++i)
        for (long j = 0; j < multiples.columns(); ++j) fmpz_set(extended.entry(i, j), multiples.entry(i, j));
      set_column(extended, multiples.columns(), line, 0, nu);
      if (extended.rank() == multiples.columns()) continue;
      multiples = std::move(extended);
      ++known;
      generators.push_back({line, nu});
    }
  }
  std::vector<MovingLine> basis;
  for (Generator& generator : generators) basis.push_back(std::move(generator.line));
  return basis;
}

MatrixRepresentation moving_line_matrix(const RationalCurve& curve, long nu) {
  if (nu < 0) throw InvalidInput("the degree of moving lines is " + std::to_string(nu), "at least 0");
  const IntegerMatrix lines = syzygies(curve, nu);
  MatrixRepresentation result;
  const auto count = static_cast<long>(curve.coordinates().size());
  for (long k = 0; k < count; ++k) {
    IntegerMatrix& coefficients = result.coefficients.emplace_back(nu + 1, lines.columns());
    for (long i = 0; i <= nu; ++i)
      for (long j = 0; j < lines.columns(); ++j)
        fmpz_set(coefficients.entry(i, j), lines.entry(k * (nu + 1) + nu - i, j));
  }
  for (long i = 0; i <= nu; ++i) result.row_monomials.push_back({static_cast<unsigned long>(nu - i)});
  return result;
}

}  // namespace eliminant::symbolic
