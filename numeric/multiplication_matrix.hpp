// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/numeric/bivariate_polynomial.hpp>
#include <eliminant/numeric/matrix_polynomial.hpp>
#include <eliminant/numeric/newton_refinement.hpp>

namespace eliminant::numeric {

// Notation. p, q of total degrees m >= n with coprime leading forms, D = m n solutions, e = m + n - 1. W_k is the space
// of polynomials of total degree at most k and of degree below m in y, with the basis x^i y^j. Row r of the hybrid
// Bezout matrix is a polynomial of (p, q) in W_(rho_r): rho_i = m + i for i < n, rho_(n+s) = n + s.

/// Matrices of multiplication by x and by y in the quotient algebra C[x, y] / (p, q), D x D, in a basis of monomials
/// that the elimination chose: X b = x b and Y b = y b for the vector b of the basis monomials at a common zero.
template <class Scalar>
struct MultiplicationMatrices {
  Matrix<Scalar> x, y;
};

/// The graded pencil: a pencil of exactly D columns from the hybrid Bezout matrix.
/// 1. The relations x^l (row r) of total degree at most e - 1 are the rows of R. Their number is dim W_(e-1) - D, and R
///    has full rank exactly when the leading forms are coprime.
/// 2. One LU factorisation of R^t with partial pivoting splits the monomials of W_(e-1) into pivots and D normal ones
/// and
///    gives the null space N = [Z; I]: every pivot monomial as a combination of normal ones.
/// 3. The m monomials of degree e follow from the relations of degree e, by the m x m matrix T of their top
/// coefficients
///    (the hybrid Bezout matrix of the leading forms, invertible).
/// 4. Row b of X is the row of x b in N, row b of Y that of y b; y^m is replaced through a_m p + b_n y^(m-n) q.
/// nullopt when a pivot vanishes or a number is out of range. Guarantee: none (floating point).
/// Derivation: docs/graded-pencil.md.
template <class Scalar>
std::optional<MultiplicationMatrices<Scalar>> multiplication_matrices(const MatrixPolynomial<Scalar>& hybrid_bezout,
                                                                      const BivariatePolynomial<Scalar>& p,
                                                                      const BivariatePolynomial<Scalar>& q, long m,
                                                                      long n);

/// The points that the eigenvectors of a generic combination of X and Y name, D of them (one of each conjugate pair);
/// empty when the QR algorithm does not converge. Simple points come out near solutions; multiple ones need other
/// means.
std::vector<PlanePoint<double>> points_by_eigenvectors(const MultiplicationMatrices<double>& matrices);

/// The same by the eigenvalues t of a generic combination alone, in two thirds of the time: the point is the common
/// zero of p and q on the line of the value t (common_zero_on_line).
std::vector<PlanePoint<double>> points_by_eigenvalues(const MultiplicationMatrices<double>& matrices,
                                                      const BivariatePolynomial<double>& p,
                                                      const BivariatePolynomial<double>& q, long m, long n);

extern template std::optional<MultiplicationMatrices<double>> multiplication_matrices(
    const MatrixPolynomial<double>&, const BivariatePolynomial<double>&, const BivariatePolynomial<double>&, long,
    long);

}  // namespace eliminant::numeric
