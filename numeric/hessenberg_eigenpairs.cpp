// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/hessenberg_eigenpairs.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/numeric/lapack.hpp>

namespace eliminant::numeric {

namespace {

constexpr int work_columns = 64;
/// The plain QR algorithm is the faster one up to about this size.
constexpr int largest_plain = 200;

}  // namespace

bool HessenbergEigenpairs::compute(const Matrix<double>& matrix) {
  n_ = static_cast<int>(matrix.rows());
  lowest_ = 1;
  highest_ = n_;
  reflectors_.resize(n_);
  real_.resize(n_);
  imaginary_.resize(n_);
  sum_real_.resize(n_);
  sum_imaginary_.resize(n_);
  work_.resize(work_columns * n_);
  const int work_size = work_columns * n_;
  int info = 0;
  reduced_ = matrix;
  if (n_ == 1) {
    real_(0) = matrix(0, 0);
    imaginary_(0) = 0;
    return true;
  }
  dgehrd_(&n_, &lowest_, &highest_, reduced_.data(), &n_, reflectors_.data(), work_.data(), &work_size, &info);
  if (info != 0) return false;
  iterated_ = reduced_;
  for (long j = 0; j + 2 < n_; ++j) iterated_.col(j).tail(n_ - j - 2).setZero();
  double unused = 0;
  const int zero = 0;
  const int one = 1;
  if (n_ <= largest_plain) {
    dlahqr_(&zero, &zero, &n_, &lowest_, &highest_, iterated_.data(), &n_, real_.data(), imaginary_.data(), &one, &n_,
            &unused, &one, &info);
  } else {
    const char eigenvalues_only = 'E';
    const char no = 'N';
    dhseqr_(&eigenvalues_only, &no, &n_, &lowest_, &highest_, iterated_.data(), &n_, real_.data(), imaginary_.data(),
            &unused, &one, work_.data(), &work_size, &info);
  }
  return info == 0;
}

const Matrix<double>& HessenbergEigenpairs::eigenvectors(const std::vector<long>& chosen, long rows) {
  long columns = 0;
  for (const long k : chosen) columns += imaginary_(k) == 0 ? 1 : 2;
  hessenberg_.resize(n_, n_);
  long column = 0;
  for (const long k : chosen) {
    const bool real = imaginary_(k) == 0;
    solve_rows_below_the_first(eigenvalue(k), hessenberg_.col(column).data(),
                               real ? nullptr : hessenberg_.col(column + 1).data());
    column += real ? 1 : 2;
  }
  if (n_ == 1) {
    result_ = hessenberg_;
    return result_;
  }
  const char left = 'L';
  const char right = 'R';
  const char no = 'N';
  const int work_size = static_cast<int>(work_.size());
  int info = 0;
  const int column_count = static_cast<int>(columns);
  if (rows == n_) {
    result_ = hessenberg_;
    dormhr_(&left, &no, &n_, &column_count, &lowest_, &highest_, reduced_.data(), &n_, reflectors_.data(),
            result_.data(), &n_, work_.data(), &work_size, &info);
    return result_;
  }
  // Only these rows of the orthogonal factor.
  const int row_count = static_cast<int>(rows);
  rows_.setZero(rows, n_);
  rows_.leftCols(rows).setIdentity();
  dormhr_(&right, &no, &row_count, &n_, &lowest_, &highest_, reduced_.data(), &n_, reflectors_.data(), rows_.data(),
          &row_count, work_.data(), &work_size, &info);
  result_.resize(rows, n_);
  const double one = 1;
  const double zero = 0;
  dgemm_(&no, &no, &row_count, &column_count, &n_, &one, rows_.data(), &row_count, hessenberg_.data(), &n_, &zero,
         result_.data(), &row_count);
  return result_;
}

/// Column by column from the last one: as soon as entry j is known, its share goes into the sums of all rows above.
void HessenbergEigenpairs::solve_rows_below_the_first(std::complex<double> value, double* real, double* imaginary) {
  constexpr double large = 1e100;
  const bool complex = imaginary != nullptr;
  sum_real_.setZero();
  sum_imaginary_.setZero();
  real[n_ - 1] = 1;
  if (complex) imaginary[n_ - 1] = 0;
  for (int j = n_ - 1; j > 0; --j) {
    const double* column = reduced_.col(j).data();
    const double re = real[j];
    const double im = complex ? imaginary[j] : 0;
    for (int i = 0; i <= j; ++i) sum_real_(i) += column[i] * re;
    if (complex)
      for (int i = 0; i <= j; ++i) sum_imaginary_(i) += column[i] * im;
    const double subdiagonal = reduced_(j, j - 1);
    real[j - 1] = (value.real() * re - value.imag() * im - sum_real_(j)) / subdiagonal;
    if (complex) imaginary[j - 1] = (value.real() * im + value.imag() * re - sum_imaginary_(j)) / subdiagonal;
    const double size = std::abs(real[j - 1]) + (complex ? std::abs(imaginary[j - 1]) : 0);
    if (size < large) continue;
    if (!std::isfinite(size)) {
      std::fill(real, real + n_, 0.0);
      if (complex) std::fill(imaginary, imaginary + n_, 0.0);
      return;
    }
    for (int i = j - 1; i < n_; ++i) {
      real[i] /= size;
      if (complex) imaginary[i] /= size;
    }
    sum_real_ /= size;
    sum_imaginary_ /= size;
  }
  double largest = 0;
  for (int i = 0; i < n_; ++i) largest = std::max(largest, std::abs(real[i]) + (complex ? std::abs(imaginary[i]) : 0));
  for (int i = 0; i < n_; ++i) {
    real[i] /= largest;
    if (complex) imaginary[i] /= largest;
  }
}

}  // namespace eliminant::numeric
