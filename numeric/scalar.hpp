// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <complex>
#include <limits>

#include <Eigen/Core>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace eliminant::numeric {

/// MPFR numbers of fixed precision on the stack; the decimal digits give at least 128, 256, 512, 1024 bits. Fixed types
/// have no global default precision and never allocate; templates are instantiated in one translation unit for each.
template <unsigned DecimalDigits>
using StackReal = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<DecimalDigits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using Real128 = StackReal<38>;
using Real256 = StackReal<77>;
using Real512 = StackReal<154>;
using Real1024 = StackReal<308>;

template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

template <class Scalar>
Scalar machine_epsilon() {
  return std::numeric_limits<Scalar>::epsilon();
}

/// |z| without the overloads that std::complex lacks for MPFR numbers.
template <class Scalar>
Scalar modulus(const std::complex<Scalar>& z) {
  using std::sqrt;
  const Scalar re = z.real();
  const Scalar im = z.imag();
  return sqrt(Scalar(re * re + im * im));
}

template <class Scalar>
bool is_finite(const std::complex<Scalar>& z) {
  using boost::multiprecision::isfinite;
  using std::isfinite;
  return isfinite(z.real()) && isfinite(z.imag());
}

/// No entry is infinite or NaN: LAPACK's routines may write outside their arrays otherwise.
template <class Derived>
bool all_finite(const Eigen::MatrixBase<Derived>& matrix) {
  using boost::multiprecision::isfinite;
  using std::isfinite;
  for (Eigen::Index j = 0; j < matrix.cols(); ++j)
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
      if (!isfinite(matrix(i, j))) return false;
  return true;
}

}  // namespace eliminant::numeric
