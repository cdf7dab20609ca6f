// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/exact_ranks.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

namespace {

class ModularMatrix {
 public:
  ModularMatrix(long rows, long columns, const PrimeField& field) {
    nmod_mat_init(value_, rows, columns, field.prime());
  }
  ModularMatrix(ModularMatrix&& other) noexcept {
    nmod_mat_init(value_, 0, 0, other.value_->mod.n);
    nmod_mat_swap(value_, other.value_);
  }
  ModularMatrix& operator=(ModularMatrix&& other) noexcept {
    nmod_mat_swap(value_, other.value_);
    return *this;
  }
  ModularMatrix(const ModularMatrix&) = delete;
  ModularMatrix& operator=(const ModularMatrix&) = delete;
  ~ModularMatrix() { nmod_mat_clear(value_); }
  nmod_mat_struct* get() { return value_; }
  const nmod_mat_struct* get() const { return value_; }
  mp_limb_t& operator()(long i, long j) { return nmod_mat_entry(value_, i, j); }
  mp_limb_t operator()(long i, long j) const { return nmod_mat_entry(value_, i, j); }

 private:
  nmod_mat_t value_;
};

ModularMatrix product(const ModularMatrix& a, const ModularMatrix& b, const PrimeField& field) {
  ModularMatrix result(nmod_mat_nrows(a.get()), nmod_mat_ncols(b.get()), field);
  nmod_mat_mul(result.get(), a.get(), b.get());
  return result;
}

/// T_m brought to echelon form E = P T_m.
struct Elimination {
  ModularMatrix transformation;   ///< P
  ModularMatrix echelon;          ///< E, reduced
  std::vector<long> pivots;       ///< pivot column of each non-zero row of E
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

  // Each of the m blocks of the newest vectors of the left deflating subspace, as an n x (number of vectors) matrix.
  std::vector<ModularMatrix> newest;
  for (long c = 0; c < m; ++c) newest.emplace_back(n, corank, field);
  {
    ModularMatrix basis(n, n, field);
    nmod_mat_nullspace(basis.get(), coefficients.back().get());
    for (long i = 0; i < n; ++i)
      for (long j = 0; j < corank; ++j) newest.back()(i, j) = basis(i, j);
  }
  long current = corank;
  while (current > 0 && static_cast<long>(step_sizes.size()) < n * m) {
    step_sizes.push_back(current);
    const ModularMatrix& last = newest.back();
    ModularMatrix image = product(coefficients[static_cast<std::size_t>(m - 1)], last, field);
    if (m > 1) nmod_mat_add(image.get(), image.get(), newest[static_cast<std::size_t>(m - 2)].get());
    const ModularMatrix transformed = product(leading.transformation, image, field);
    // The rows beyond the rank are what keeps the image out of the range of T_m.
    ModularMatrix obstruction(corank, current, field);
    for (long i = 0; i < corank; ++i)
      for (long j = 0; j < current; ++j) obstruction(i, j) = transformed(rank + i, j);
    ModularMatrix kernel(current, current, field);
    const long next = nmod_mat_nullspace(kernel.get(), obstruction.get());
    if (next == 0) break;
    ModularMatrix combination(current, next, field);
    for (long i = 0; i < current; ++i)
      for (long j = 0; j < next; ++j) combination(i, j) = kernel(i, j);
    std::vector<ModularMatrix> following;
    const ModularMatrix last_combined = product(last, combination, field);
    for (long c = 0; c + 1 < m; ++c) {
      following.push_back(product(coefficients[static_cast<std::size_t>(c)], last_combined, field));
      if (c == 0) continue;
      const ModularMatrix shifted = product(newest[static_cast<std::size_t>(c - 1)], combination, field);
      nmod_mat_add(following.back().get(), following.back().get(), shifted.get());
    }
    // The last block u solves -T_m u = image: its pivot entries are those of -P image.
    following.emplace_back(n, next, field);
    const ModularMatrix right_hand_side = product(transformed, combination, field);
    for (long i = 0; i < rank; ++i)
      for (long j = 0; j < next; ++j)
        following.back()(leading.pivots[static_cast<std::size_t>(i)], j) = field.negate(right_hand_side(i, j));
    newest = std::move(following);
    current = next;
  }
  return step_sizes;
}

}  // namespace eliminant::symbolic
