// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial_matrix.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// The Bezoutian matrix of the intersection of Phi(u, v) and Psi(s, t) with its two variables apart: its entry in row
/// s^i v^j and column s^i' v^j' is the incidence of two sums of lines,
///   L_jj'(u) = sum over p of A_p ^ A_(j+j'+1-p),   M_ii'(t) = sum over r of C_r ^ C_(i+i'+1-r),
/// the sum of the six products of Pluecker coordinates (bezoutian_matrix.hpp has the notation). Evaluating it costs six
/// products an entry.
///
/// The surface's own self-intersection: with Phi twice the matrix has the kernel w = (u^i t^j), and its adjugate is
/// D w w^T, D the determinant of the self-intersection in (u, v) with v written t. The minor without row and column
/// (i, j) is D u^(2i) v^(2j); without (0, 0) it is D: the changes of parameters s = u + l and t = v + k are unipotent
/// congruences.
class SeparatedBezoutian {
 public:
  /// Coordinates such that incidence is the plain product of the two vectors.
  using LineCoordinates = std::array<UnivariatePolynomial, 6>;

  /// Throws InvalidInput for a surface of triangular kind or one that does not depend on the eliminated parameter.
  SeparatedBezoutian(const RationalSurface& first, const RationalSurface& second);

  /// deg_v Phi and deg_s Psi.
  std::size_t first_degree() const { return n_; }
  std::size_t second_degree() const { return m_; }
  std::size_t size() const { return n_ * m_; }
  /// L_jj' over Z[u] and M_ii' over Z[t]; both symmetric in their indices.
  const LineCoordinates& first_lines(std::size_t j, std::size_t k) const { return first_[j * n_ + k]; }
  const LineCoordinates& second_lines(std::size_t i, std::size_t k) const { return second_[i * m_ + k]; }

  /// The matrix over Z[t] for one value of u, times the power of its denominator that makes it integral; its
  /// determinant vanishes at all t of the intersection above this u.
  PolynomialMatrix at_first_parameter(const Rational& u) const;

 private:
  std::size_t n_ = 0;
  std::size_t m_ = 0;
  std::vector<LineCoordinates> first_;
  std::vector<LineCoordinates> second_;
};

}  // namespace eliminant::symbolic
