// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/numeric/scalar.hpp>

namespace eliminant::numeric {

/// Eigenvalues and right eigenvectors of real matrices, for many matrices in turn: no memory is allocated after the
/// first one of a size.
///
/// The matrix is reduced to Hessenberg form H, the QR algorithm finds the eigenvalues alone, and an eigenvector of H is
/// the solution of all rows of H - x but the first, from below ([Wilkinson1965], Hyman's method): one step of inverse
/// iteration with the first unit vector, at a quarter of the cost of back substitution in a Schur form. It fails, and
/// says so by a large error of the vector, when that vector has no part of the eigenvector's.
/// Guarantee: none (floating point).
class HessenbergEigenpairs {
 public:
  /// Factors the matrix, which must be finite; false when the QR algorithm does not converge.
  bool compute(const Matrix<double>& matrix);

  long size() const { return n_; }
  /// The second ones of conjugate pairs have negative imaginary part.
  std::complex<double> eigenvalue(long k) const { return {real_(k), imaginary_(k)}; }

  /// The first `rows` entries of an eigenvector of each chosen eigenvalue: a column where it is real, else two columns,
  /// real and imaginary part. Columns that overflowed are zero, those after the last one are without meaning.
  const Matrix<double>& eigenvectors(const std::vector<long>& chosen, long rows);

 private:
  void solve_rows_below_the_first(std::complex<double> value, double* real, double* imaginary);

  int n_ = 0;
  int lowest_ = 1;
  int highest_ = 0;
  Matrix<double> reduced_;     // Hessenberg form, and below it the reflectors
  Matrix<double> iterated_;    // what the QR algorithm works on
  Matrix<double> hessenberg_;  // eigenvectors in the coordinates of the Hessenberg form
  Matrix<double> rows_;        // rows of the orthogonal factor
  Matrix<double> result_;
  Vector<double> reflectors_, real_, imaginary_, sum_real_, sum_imaginary_, work_;
};

}  // namespace eliminant::numeric
