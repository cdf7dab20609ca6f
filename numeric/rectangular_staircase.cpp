// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/rectangular_staircase.hpp>

#include <Eigen/QR>

#include <eliminant/base/error.hpp>

namespace eliminant::numeric {

namespace {

/// An orthogonal matrix whose first columns span the range of `matrix`, as many as its rank, which is known.
Matrix<double> range_first(const Matrix<double>& matrix) {
  const Eigen::ColPivHouseholderQR<Matrix<double>> qr(matrix);
  return qr.householderQ() * Matrix<double>::Identity(matrix.rows(), matrix.rows());
}

void deflate(Pencil<double>& pencil, const StaircaseSteps& steps) {
  for (const auto& [rank_b, rank_a] : steps) {
    const long rows = pencil.b.rows();
    const long columns = pencil.b.cols();
    if (rank_b < 0 || rank_b > columns || rank_a < 0 || rank_a > rows)
      throw InvalidInput("the ranks of the staircase exceed the size of the pencil", "ranks of this pencil");
    // Step 1: columns of B that are zero.
    const Matrix<double> right = range_first(pencil.b.transpose());
    const Matrix<double> kept = right.leftCols(rank_b);
    // Step 2: rows of A that these columns do not reach.
    const Matrix<double> left = range_first(pencil.a * right.rightCols(columns - rank_b));
    const Matrix<double> rows_left = left.rightCols(rows - rank_a).transpose();
    pencil.a = rows_left * pencil.a * kept;
    pencil.b = rows_left * pencil.b * kept;
  }
}

}  // namespace

Pencil<double> rectangular_companion_pencil(const std::vector<Matrix<double>>& coefficients) {
  const long p = coefficients.front().rows();
  const long q = coefficients.front().cols();
  const long m = static_cast<long>(coefficients.size()) - 1;
  const long identities = (m - 1) * q;
  Pencil<double> pencil{Matrix<double>::Zero(identities + p, m * q), Matrix<double>::Zero(identities + p, m * q)};
  pencil.a.block(0, q, identities, identities).setIdentity();
  pencil.b.block(0, 0, identities, identities).setIdentity();
  for (long k = 0; k < m; ++k) pencil.a.block(identities, k * q, p, q) = coefficients[static_cast<std::size_t>(k)];
  pencil.b.block(identities, (m - 1) * q, p, q) = -coefficients.back();
  return pencil;
}

Pencil<double> regular_part_staircase(const Pencil<double>& pencil, const StaircaseSteps& column_steps,
                                      const StaircaseSteps& row_steps) {
  Pencil<double> result = pencil;
  deflate(result, column_steps);
  result.a.transposeInPlace();
  result.b.transposeInPlace();
  deflate(result, row_steps);
  result.a.transposeInPlace();
  result.b.transposeInPlace();
  if (result.a.rows() != result.a.cols())
    throw InvalidInput("the ranks of the staircase leave a pencil that is not square", "ranks of this pencil");
  return result;
}

}  // namespace eliminant::numeric
