// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/numeric/bivariate_polynomial.hpp>
#include <eliminant/numeric/matrix_polynomial.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/arithmetic/polynomial_matrix.hpp>

namespace eliminant::bridge {

/// A rounded object: the exact one is 2^scale_log2 * value, up to a relative error of at most 2^-relative_error_bits in
/// every coefficient (correct rounding). In double precision a coefficient that is smaller than 2^-1022 after scaling
/// has instead an absolute error of at most 2^-1075; the largest one is in [1/2, 1].
template <class T>
struct Rounded {
  T value;
  long scale_log2 = 0;
  long relative_error_bits = 0;
};

/// The coefficient matrices of a matrix over Z[x], rounded to nearest. Scalar is double or one of the MPFR types of
/// numeric/scalar.hpp. The matrix is square and not zero.
template <class Scalar>
Rounded<numeric::MatrixPolynomial<Scalar>> round_matrix(const symbolic::PolynomialMatrix& matrix);

/// The coefficients of a non-zero bivariate polynomial, rounded to nearest.
template <class Scalar>
Rounded<numeric::BivariatePolynomial<Scalar>> round_polynomial(const symbolic::Polynomial& p);

}  // namespace eliminant::bridge
