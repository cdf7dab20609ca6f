// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>

namespace eliminant::symbolic {

IntegerMatrix nullspace(const IntegerMatrix& a) {
  IntegerMatrix reduced(a.rows(), a.columns());
  Integer denominator;
  // Of FLINT's ways the fastest one at the sizes of moving lines and planes.
  const long rank = fmpz_mat_rref_fflu(reduced.get(), denominator.get(), a.get());
  std::vector<long> pivots;
  std::vector<long> free_columns;
  for (long j = 0; j < a.columns(); ++j) {
    const auto row = static_cast<long>(pivots.size());
    if (row < rank && fmpz_is_zero(reduced.entry(row, j)) == 0)
      pivots.push_back(j);
    else
      free_columns.push_back(j);
  }
  IntegerMatrix basis(a.columns(), static_cast<long>(free_columns.size()));
  for (std::size_t k = 0; k < free_columns.size(); ++k) {
    const auto column = static_cast<long>(k);
    const long free_column = free_columns[k];
    Integer content = denominator;
    for (std::size_t i = 0; i < pivots.size(); ++i)
      fmpz_gcd(content.get(), content.get(), reduced.entry(static_cast<long>(i), free_column));
    if (denominator.sign() < 0) content = -content;
    fmpz_divexact(basis.entry(free_column, column), denominator.get(), content.get());
    for (std::size_t i = 0; i < pivots.size(); ++i) {
      fmpz* const entry = basis.entry(pivots[i], column);
      fmpz_divexact(entry, reduced.entry(static_cast<long>(i), free_column), content.get());
      fmpz_neg(entry, entry);
    }
  }
  return basis;
}

}  // namespace eliminant::symbolic
