// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <eliminant/numeric/companion_pencil.hpp>

namespace eliminant::numeric {

/// Eigenvalues x_k and right eigenvectors v_k (columns) of a pencil: A v = x B v.
template <class Scalar>
struct Eigenpairs {
  Vector<std::complex<Scalar>> values;
  Matrix<std::complex<Scalar>> vectors;
};

/// All eigenpairs of a pencil with invertible B, in no particular order; nullopt when the iteration does not converge
/// or the entries are too large.
/// MPFR scalars: LU of B, then the QR algorithm; it is two to three times cheaper than QZ there.
template <class Scalar>
std::optional<Eigenpairs<Scalar>> generalized_eigen(const Pencil<Scalar>& pencil) {
  const Matrix<Scalar> product = pencil.b.partialPivLu().solve(pencil.a);
  if (!all_finite(product)) return std::nullopt;
  const Eigen::EigenSolver<Matrix<Scalar>> solver(product);
  if (solver.info() != Eigen::Success) return std::nullopt;
  return Eigenpairs<Scalar>{solver.eigenvalues(), solver.eigenvectors()};
}

/// Double precision: LAPACK's QZ. Eigenvalues that come out infinite are left out.
template <>
std::optional<Eigenpairs<double>> generalized_eigen(const Pencil<double>& pencil);

}  // namespace eliminant::numeric
