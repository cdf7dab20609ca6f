// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::symbolic {

/// A rows x columns matrix over Z[t].
class PolynomialMatrix {
 public:
  PolynomialMatrix(long rows, long columns) { fmpz_poly_mat_init(value_, rows, columns); }
  PolynomialMatrix(const PolynomialMatrix& other) { fmpz_poly_mat_init_set(value_, other.value_); }
  PolynomialMatrix(PolynomialMatrix&& other) noexcept : PolynomialMatrix(0, 0) {
    fmpz_poly_mat_swap(value_, other.value_);
  }
  PolynomialMatrix& operator=(PolynomialMatrix other) noexcept {
    fmpz_poly_mat_swap(value_, other.value_);
    return *this;
  }
  ~PolynomialMatrix() { fmpz_poly_mat_clear(value_); }

  long rows() const { return fmpz_poly_mat_nrows(value_); }
  long columns() const { return fmpz_poly_mat_ncols(value_); }
  UnivariatePolynomial entry(long row, long column) const {
    return UnivariatePolynomial(fmpz_poly_mat_entry(value_, row, column));
  }
  void set_entry(long row, long column, const UnivariatePolynomial& value) {
    fmpz_poly_set(fmpz_poly_mat_entry(value_, row, column), value.get());
  }
  /// Largest degree of an entry; -1 for the zero matrix.
  long degree() const { return fmpz_poly_mat_max_length(value_) - 1; }
  PolynomialMatrix transposed() const;

  fmpz_poly_mat_struct* get() { return value_; }
  const fmpz_poly_mat_struct* get() const { return value_; }

 private:
  fmpz_poly_mat_t value_;
};

/// The determinant of a square matrix, by interpolation. Throws InvalidInput when the matrix is not square. For
/// Sylvester and Bezout matrices `resultant` is much faster.
UnivariatePolynomial determinant(const PolynomialMatrix& matrix);

}  // namespace eliminant::symbolic
