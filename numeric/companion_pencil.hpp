// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/numeric/matrix_polynomial.hpp>

namespace eliminant::numeric {

/// The pencil A - x B.
template <class Scalar>
struct Pencil {
  Matrix<Scalar> a;
  Matrix<Scalar> b;

  long size() const { return a.rows(); }
};

/// The companion pencil of T: with n = size and m = degree >= 1 of T, two mn x mn matrices
///
///     A = [ 0     I                 ]      B = [ I               ]
///         [             ...         ]          [     ...         ]
///         [                   I     ]          [         I       ]
///         [ T_0^t T_1^t ... T_m-1^t ]          [           -T_m^t ]
///
/// such that T(x)^t v = 0 exactly when (A - x B)(v, x v, ..., x^(m-1) v) = 0.
/// Source: [BuseKhalilMourrain2005], Definition 3 and Proposition 4.
template <class Scalar>
Pencil<Scalar> companion_pencil(const MatrixPolynomial<Scalar>& t) {
  const long n = t.size();
  const long m = t.degree();
  Pencil<Scalar> pencil{Matrix<Scalar>::Zero(n * m, n * m), Matrix<Scalar>::Zero(n * m, n * m)};
  for (long k = 0; k + 1 < m; ++k) {
    pencil.a.block(k * n, (k + 1) * n, n, n).setIdentity();
    pencil.b.block(k * n, k * n, n, n).setIdentity();
  }
  for (long k = 0; k < m; ++k)
    pencil.a.block((m - 1) * n, k * n, n, n) = t.coefficients[static_cast<std::size_t>(k)].transpose();
  pencil.b.block((m - 1) * n, (m - 1) * n, n, n) = -t.coefficients.back().transpose();
  return pencil;
}

}  // namespace eliminant::numeric
