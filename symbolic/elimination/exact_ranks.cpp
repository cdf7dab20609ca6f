// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include <eliminant/symbolic/elimination/exact_ranks.hpp>
#include <eliminant/symbolic/elimination/modular_matrix.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

namespace {

ModularMatrix product(const ModularMatrix& a, const ModularMatrix& b, const PrimeField& field) {
  ModularMatrix result(nmod_mat_nrows(a.get()), nmod_mat_ncols(b.get()), field);
  nmod_mat_mul(result.get(), a.get(), b.get());
  return result;
}

ModularMatrix columns(const ModularMatrix& matrix, const std::vector<long>& selection, const PrimeField& field) {
  const long rows = nmod_mat_nrows(matrix.get());
  ModularMatrix result(rows, static_cast<long>(selection.size()), field);
  for (long i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < selection.size(); ++j) result(i, static_cast<long>(j)) = matrix(i, selection[j]);
  return result;
}

std::vector<long> first_columns(long count) {
  std::vector<long> result(static_cast<std::size_t>(count));
  std::iota(result.begin(), result.end(), 0L);
  return result;
}

/// Block by block, the columns of `left` followed by those of `right`.
std::vector<ModularMatrix> side_by_side(const std::vector<ModularMatrix>& left, const std::vector<ModularMatrix>& right,
                                        const PrimeField& field) {
  std::vector<ModularMatrix> result;
  for (std::size_t c = 0; c < left.size(); ++c) {
    const long rows = nmod_mat_nrows(left[c].get());
    const long split = nmod_mat_ncols(left[c].get());
    result.emplace_back(rows, split + nmod_mat_ncols(right[c].get()), field);
    for (long i = 0; i < rows; ++i)
      for (long j = 0; j < nmod_mat_ncols(result[c].get()); ++j)
        result[c](i, j) = j < split ? left[c](i, j) : right[c](i, j - split);
  }
  return result;
}

/// The columns in which the echelon form of a matrix has its pivots: the first independent ones.
std::vector<long> pivot_columns(ModularMatrix matrix) {
  const long rank = nmod_mat_rref(matrix.get());
  std::vector<long> pivots;
  for (long i = 0, j = 0; i < rank; ++i, ++j) {
    while (matrix(i, j) == 0) ++j;
    pivots.push_back(j);
  }
  return pivots;
}

/// T_m brought to echelon form E = P T_m.
struct Elimination {
  ModularMatrix transformation;  ///< P
  ModularMatrix echelon;         ///< E, reduced
  std::vector<long> pivots;      ///< pivot column of each non-zero row of E
};

Elimination eliminate(const ModularMatrix& matrix, const PrimeField& field) {
  const long n = nmod_mat_nrows(matrix.get());
  ModularMatrix augmented(n, 2 * n, field);
  for (long i = 0; i < n; ++i) {
    for (long j = 0; j < n; ++j) augmented(i, j) = matrix(i, j);
    augmented(i, n + i) = 1;
  }
  nmod_mat_rref(augmented.get());
  Elimination result{ModularMatrix(n, n, field), ModularMatrix(n, n, field), {}};
  for (long i = 0; i < n; ++i) {
    for (long j = 0; j < n; ++j) {
      result.echelon(i, j) = augmented(i, j);
      result.transformation(i, j) = augmented(i, n + j);
    }
    long pivot = 0;
    while (pivot < n && augmented(i, pivot) == 0) ++pivot;
    if (pivot < n) result.pivots.push_back(pivot);
  }
  return result;
}

}  // namespace

std::vector<long> infinite_structure_modulo(const PolynomialMatrix& t, std::uint64_t seed) {
  const long n = t.rows();
  const long m = t.degree();
  const PrimeField field(PrimeSequence(mix(seed, 4)).next());
  std::vector<ModularMatrix> coefficients;
  for (long k = 0; k <= m; ++k) {
    coefficients.emplace_back(n, n, field);
    Integer coefficient;
    for (long i = 0; i < n; ++i)
      for (long j = 0; j < n; ++j) {
        fmpz_poly_get_coeff_fmpz(coefficient.get(), fmpz_poly_mat_entry(t.get(), i, j), k);
        coefficients.back()(i, j) = field.reduce(coefficient);
      }
  }
  const Elimination leading = eliminate(coefficients.back(), field);
  const auto rank = static_cast<long>(leading.pivots.size());
  const long corank = n - rank;
  std::vector<long> step_sizes;
  if (corank == 0) return step_sizes;

  // Vectors of the left deflating subspace, cut into m blocks: block c of k vectors is an n x k matrix. `newest` are
  // those of the last step, `stuck` those of earlier steps whose image under A^t is independent modulo the range of
  // B^t.
  const auto blocks = [&](long count) {
    std::vector<ModularMatrix> result;
    for (long c = 0; c < m; ++c) result.emplace_back(n, count, field);
    return result;
  };
  std::vector<ModularMatrix> newest = blocks(corank);
  std::vector<ModularMatrix> stuck = blocks(0);
  {
    ModularMatrix basis(n, n, field);
    nmod_mat_nullspace(basis.get(), coefficients.back().get());
    for (long i = 0; i < n; ++i)
      for (long j = 0; j < corank; ++j) newest.back()(i, j) = basis(i, j);
  }
  while (static_cast<long>(step_sizes.size()) < n * m) {
    const long current = nmod_mat_ncols(newest.back().get());
    step_sizes.push_back(current);
    const std::vector<ModularMatrix> all = side_by_side(stuck, newest, field);
    const long count = nmod_mat_ncols(all.back().get());
    const ModularMatrix& last = all.back();
    ModularMatrix image = product(coefficients[static_cast<std::size_t>(m - 1)], last, field);
    if (m > 1) nmod_mat_add(image.get(), image.get(), all[static_cast<std::size_t>(m - 2)].get());
    const ModularMatrix transformed = product(leading.transformation, image, field);
    // The rows beyond the rank are what keeps the image out of the range of T_m.
    ModularMatrix obstruction(corank, count, field);
    for (long i = 0; i < corank; ++i)
      for (long j = 0; j < count; ++j) obstruction(i, j) = transformed(rank + i, j);
    ModularMatrix combination(count, count, field);
    const long next = nmod_mat_nullspace(combination.get(), obstruction.get());
    if (next == 0) break;
    combination = columns(combination, first_columns(next), field);
    std::vector<ModularMatrix> following;
    const ModularMatrix last_combined = product(last, combination, field);
    for (long c = 0; c + 1 < m; ++c) {
      following.push_back(product(coefficients[static_cast<std::size_t>(c)], last_combined, field));
      if (c == 0) continue;
      const ModularMatrix shifted = product(all[static_cast<std::size_t>(c - 1)], combination, field);
      nmod_mat_add(following.back().get(), following.back().get(), shifted.get());
    }
    // The last block u solves -T_m u = image: its pivot entries are those of -P image.
    following.emplace_back(n, next, field);
    const ModularMatrix right_hand_side = product(transformed, combination, field);
    for (long i = 0; i < rank; ++i)
      for (long j = 0; j < next; ++j)
        following.back()(leading.pivots[static_cast<std::size_t>(i)], j) = field.negate(right_hand_side(i, j));
    const std::vector<long> pivots = pivot_columns(std::move(obstruction));
    for (std::size_t c = 0; c < stuck.size(); ++c) stuck[c] = columns(all[c], pivots, field);
    newest = std::move(following);
  }
  return step_sizes;
}

}  // namespace eliminant::symbolic
