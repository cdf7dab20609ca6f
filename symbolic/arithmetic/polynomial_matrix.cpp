// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/polynomial_matrix.hpp>

namespace eliminant::symbolic {

PolynomialMatrix PolynomialMatrix::transposed() const {
  PolynomialMatrix result(columns(), rows());
  fmpz_poly_mat_transpose(result.value_, value_);
  return result;
}

UnivariatePolynomial determinant(const PolynomialMatrix& matrix) {
  if (matrix.rows() != matrix.columns())
    throw InvalidInput("the determinant of a " + std::to_string(matrix.rows()) + " x " +
                           std::to_string(matrix.columns()) + " matrix was asked for",
                       "a square matrix");
  UnivariatePolynomial result;
  fmpz_poly_mat_det(result.get(), matrix.get());
  return result;
}

}  // namespace eliminant::symbolic
