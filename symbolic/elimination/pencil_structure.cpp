// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/pencil_structure.hpp>

#include <utility>

#include <eliminant/symbolic/elimination/modular_matrix.hpp>

namespace eliminant::symbolic {

namespace {

ModularMatrix transposed(const ModularMatrix& matrix, const PrimeField& field) {
  ModularMatrix result(nmod_mat_ncols(matrix.get()), nmod_mat_nrows(matrix.get()), field);
  nmod_mat_transpose(result.get(), matrix.get());
  return result;
}

ModularMatrix product(const ModularMatrix& a, const ModularMatrix& b, const PrimeField& field) {
  ModularMatrix result(nmod_mat_nrows(a.get()), nmod_mat_ncols(b.get()), field);
  nmod_mat_mul(result.get(), a.get(), b.get());
  return result;
}

/// The columns of the result span the right kernel.
ModularMatrix kernel(const ModularMatrix& matrix, const PrimeField& field) {
  const long columns = nmod_mat_ncols(matrix.get());
  ModularMatrix all(columns, columns, field);
  const long count = nmod_mat_nullspace(all.get(), matrix.get());
  ModularMatrix result(columns, count, field);
  for (long i = 0; i < columns; ++i)
    for (long j = 0; j < count; ++j) result(i, j) = all(i, j);
  return result;
}

/// The first independent columns of `matrix`, as positions.
std::vector<long> independent_columns(const ModularMatrix& matrix, const PrimeField& field) {
  ModularMatrix echelon(nmod_mat_nrows(matrix.get()), nmod_mat_ncols(matrix.get()), field);
  nmod_mat_set(echelon.get(), matrix.get());
  const long rank = nmod_mat_rref(echelon.get());
  std::vector<long> positions;
  for (long i = 0, j = 0; i < rank; ++i, ++j) {
    while (echelon(i, j) == 0) ++j;
    positions.push_back(j);
  }
  return positions;
}

ModularMatrix selected(const ModularMatrix& matrix, const std::vector<long>& columns, const PrimeField& field) {
  const long rows = nmod_mat_nrows(matrix.get());
  ModularMatrix result(rows, static_cast<long>(columns.size()), field);
  for (long i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns.size(); ++j) result(i, static_cast<long>(j)) = matrix(i, columns[j]);
  return result;
}

struct ModularPencil {
  ModularMatrix a;
  ModularMatrix b;
};

/// Steps 1 and 2 of section 3.3 until B has full column rank.
std::vector<std::array<long, 2>> deflate(ModularPencil& pencil, const PrimeField& field) {
  std::vector<std::array<long, 2>> steps;
  for (;;) {
    const std::vector<long> kept = independent_columns(pencil.b, field);
    const auto rank = static_cast<long>(kept.size());
    if (rank == nmod_mat_ncols(pencil.b.get())) return steps;
    const ModularMatrix reached = product(pencil.a, kernel(pencil.b, field), field);
    const ModularMatrix rows = transposed(kernel(transposed(reached, field), field), field);
    steps.push_back({rank, nmod_mat_nrows(reached.get()) - nmod_mat_nrows(rows.get())});
    pencil.a = product(rows, selected(pencil.a, kept, field), field);
    pencil.b = product(rows, selected(pencil.b, kept, field), field);
  }
}

ModularPencil companion(const MatrixRepresentation& m, const RationalCurve& curve, const PrimeField& field) {
  const long rows = m.rows();
  const long columns = m.columns();
  const long degree = curve.degree();
  const long identities = (degree - 1) * rows;
  ModularPencil pencil{ModularMatrix(identities + columns, degree * rows, field),
                       ModularMatrix(identities + columns, degree * rows, field)};
  for (long i = 0; i < identities; ++i) {
    pencil.a(i, rows + i) = 1;
    pencil.b(i, i) = 1;
  }
  for (std::size_t k = 0; k < m.coefficients.size(); ++k) {
    ModularMatrix block(rows, columns, field);
    fmpz_mat_get_nmod_mat(block.get(), m.coefficients[k].get());
    for (long power = 0; power <= degree; ++power) {
      const mp_limb_t factor = field.reduce(curve.coordinates()[k].coefficient(power));
      const bool leading = power == degree;
      ModularMatrix& target = leading ? pencil.b : pencil.a;
      const long first = (leading ? degree - 1 : power) * rows;
      const mp_limb_t signed_factor = leading ? field.negate(factor) : factor;
      for (long i = 0; i < rows; ++i)
        for (long j = 0; j < columns; ++j)
          target(identities + j, first + i) =
              field.add(target(identities + j, first + i), field.multiply(signed_factor, block(i, j)));
    }
  }
  return pencil;
}

}  // namespace

PencilStructure pencil_structure_modulo(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed) {
  const PrimeField field(PrimeSequence(mix(seed, 5)).next());
  ModularPencil pencil = companion(m, curve, field);
  PencilStructure structure;
  long columns = nmod_mat_ncols(pencil.b.get());
  structure.column_steps = deflate(pencil, field);
  for (const auto& [rank_b, rank_a] : structure.column_steps) {
    // A kernel of B of which A does not reach as much belongs to a pencil without full column rank.
    structure.full_rank = structure.full_rank && rank_a == columns - rank_b;
    columns = rank_b;
  }
  pencil = {transposed(pencil.a, field), transposed(pencil.b, field)};
  structure.row_steps = deflate(pencil, field);
  structure.regular_size = nmod_mat_nrows(pencil.b.get());
  return structure;
}

}  // namespace eliminant::symbolic
