// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// A matrix of polynomials whose rows and columns belong to monomials in the eliminated variables.
class BezoutianMatrix {
 public:
  /// Exponents of the eliminated variables, one for each.
  using Monomial = std::vector<unsigned long>;

  /// `entries` row by row. Throws InvalidInput when their number is not that of rows times columns.
  BezoutianMatrix(std::vector<Monomial> row_monomials, std::vector<Monomial> column_monomials,
                  std::vector<Polynomial> entries);

  std::size_t rows() const { return row_monomials_.size(); }
  std::size_t columns() const { return column_monomials_.size(); }
  const std::vector<Monomial>& row_monomials() const { return row_monomials_; }
  const std::vector<Monomial>& column_monomials() const { return column_monomials_; }
  const Polynomial& entry(std::size_t row, std::size_t column) const { return entries_[row * columns() + column]; }
  bool is_symmetric() const;

 private:
  std::vector<Monomial> row_monomials_;
  std::vector<Monomial> column_monomials_;
  std::vector<Polynomial> entries_;
};

/// The Bezoutian matrix of n + 1 polynomials in the n variables whose indices are `eliminated`, in that order: with x
/// and y for two copies of these variables, row of y^beta and column of x^alpha holds the coefficient of x^alpha y^beta
/// in the determinant of (f_j(x), d_1 f_j, ..., d_n f_j), where d_i f_j is the divided difference
/// (f_j(y_1, ..., y_(i-1), x_i, ..., x_n) - f_j(y_1, ..., y_i, x_(i+1), ..., x_n)) / (x_i - y_i).
/// Entries are polynomials in the variables that remain (in the same ring); monomials by increasing exponents, the
/// exponent of the first eliminated variable first. No row and no column is zero; the matrix need not be square.
/// Throws InvalidInput when the numbers of polynomials and variables do not fit.
/// Source: [BuseElkadiGalligo2008], Definition 1.
BezoutianMatrix bezoutian_matrix(std::span<const Polynomial> polynomials, std::span<const std::size_t> eliminated);

/// The curve sum of columns[k] x^k in projective space: its coefficients are four polynomials each, the weight first.
using CoefficientVectors = std::vector<std::array<Polynomial, 4>>;

/// The Bezoutian matrix of the curves A(v) = sum A_j v^j (j <= n) and C(s) = sum C_i s^i (i <= m), that is of the
/// condition that they meet: row of s^i v^j, column of s^i' v^j', i, i' < m, j, j' < n,
///   sum over p + q = j + j' + 1 and r + w = i + i' + 1 of det(A_p, A_q, C_r, C_w), p <= min(j, j'), r <= min(i, i').
/// Size mn over the ring of the coefficients, symmetric; rows by increasing i, then j. Where both weights are 1 it is
/// minus the matrix of Definition 1 for the differences of the coordinates and the variables (v, s).
/// Source: [BuseElkadiGalligo2008], sections 5.1 and 6.1.
BezoutianMatrix separated_bezoutian_matrix(const CoefficientVectors& first, const CoefficientVectors& second);

/// Of Phi(u, v) and Psi(s, t), the matrix of their intersection with v and s eliminated, over Z[u, t] (u is variable 0,
/// t variable 1): size deg_v Phi * deg_s Psi, row of s^i v^j. Its determinant vanishes where Phi(u, v) and Psi(s, t)
/// are one point of space for some v and s, infinity included. The vector (s^i v^j) is in its kernel there. Throws
/// InvalidInput for a surface of triangular kind or one that does not depend on the eliminated parameter. Source:
/// [BuseElkadiGalligo2008], Theorem 2 (polynomial surfaces) and Theorem 3.
BezoutianMatrix intersection_bezoutian_matrix(const RationalSurface& first, const RationalSurface& second);

/// The matrix of the self-intersection Phi(u, v + k) = Phi(u + l, v) over Z[u, v]: size mn - 1, rows of l^i k^j
/// without the first, which vanishes. Empty for a bilinear surface, which does not meet itself.
/// Throws InvalidInput for a surface of triangular kind or one that depends on one parameter only.
/// Source: [BuseElkadiGalligo2008], Theorem 4 (polynomial surfaces) and Theorem 5.
BezoutianMatrix self_intersection_bezoutian_matrix(const RationalSurface& surface);

/// The determinant by expansion, exact; for small matrices (bezoutian_determinant interpolates). 1 for an empty matrix.
/// Throws InvalidInput when the matrix is not square.
Polynomial determinant(const BezoutianMatrix& matrix);

}  // namespace eliminant::symbolic
