// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <eliminant/numeric/scalar.hpp>

namespace eliminant::numeric {

/// Smallest r with sigma_(r+1) <= tolerance * sigma_1: the numerical rank of [BuseKhalilMourrain2005], section 4.1.
template <class Scalar, class Values>
long numerical_rank(const Values& singular_values, const Scalar& tolerance) {
  if (singular_values.size() == 0 || !(singular_values(0) > 0)) return 0;
  long rank = 1;
  while (rank < singular_values.size() && singular_values(rank) > tolerance * singular_values(0)) ++rank;
  return rank;
}

/// An orthogonal basis (columns) of the span of the columns of `vectors`, as many as its numerical rank: E'' = U Sigma
/// of the singular value decomposition (section 4.1, difficulty c).
template <class Scalar>
Matrix<std::complex<Scalar>> independent_vectors(const Matrix<std::complex<Scalar>>& vectors, const Scalar& tolerance) {
  const Eigen::JacobiSVD<Matrix<std::complex<Scalar>>> svd(vectors, Eigen::ComputeThinU);
  return svd.matrixU().leftCols(numerical_rank<Scalar>(svd.singularValues(), tolerance));
}

/// The vectors v with |M v| <= tolerance |M|: the last columns of V of the singular value decomposition.
template <class Scalar>
Matrix<std::complex<Scalar>> kernel(const Matrix<std::complex<Scalar>>& matrix, const Scalar& tolerance) {
  const Eigen::JacobiSVD<Matrix<std::complex<Scalar>>> svd(matrix, Eigen::ComputeFullV);
  return svd.matrixV().rightCols(matrix.cols() - numerical_rank<Scalar>(svd.singularValues(), tolerance));
}

/// The y coordinates above one x: `basis` (n x r, r < n) spans the vectors (1, y, ..., y^(n-1)) of the fibre (and their
/// derivatives in y for a multiple root of the fibre). Delta_0 and Delta_1 are its first r rows and rows 2 to r + 1,
/// and the y are the eigenvalues of Delta_1 - y Delta_0. Infinite ones (both leading coefficients vanish) are left out.
/// Source: [BuseKhalilMourrain2005], Propositions 7 and 8.
template <class Scalar>
std::vector<std::complex<Scalar>> fibre_coordinates(const Matrix<std::complex<Scalar>>& basis) {
  using Complex = std::complex<Scalar>;
  const long r = basis.cols();
  std::vector<Complex> result;
  if (r == 0 || r >= basis.rows()) return result;
  const Matrix<Complex> delta_0 = basis.topRows(r);
  const Matrix<Complex> delta_1 = basis.middleRows(1, r);
  // With N = Delta_0 + c Delta_1 for some c, the eigenvalues of N^-1 Delta_1 are z = y / (1 + c y); y infinite is
  // z = 1 / c, and N is invertible unless y = -1 / c is a solution.
  const Complex c(Scalar(0.6180339887498949), Scalar(0.4142135623730951));
  const Matrix<Complex> sum = delta_0 + c * delta_1;
  const Eigen::FullPivLU<Matrix<Complex>> lu(sum);
  if (!lu.isInvertible()) return result;
  Vector<Complex> z;
  const Matrix<Complex> product = lu.solve(delta_1);
  if (r == 1) {
    z = product.col(0);
  } else {
    const Eigen::ComplexEigenSolver<Matrix<Complex>> solver(product, false);
    if (solver.info() != Eigen::Success) return result;
    z = solver.eigenvalues();
  }
  for (long i = 0; i < z.size(); ++i) {
    const Complex denominator = Complex(Scalar(1)) - c * z(i);
    if (!(modulus<Scalar>(denominator) > Scalar(16) * machine_epsilon<Scalar>())) continue;
    const Complex y = z(i) / denominator;
    if (is_finite(y)) result.push_back(y);
  }
  return result;
}

}  // namespace eliminant::numeric
