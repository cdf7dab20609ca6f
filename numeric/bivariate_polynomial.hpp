// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/numeric/scalar.hpp>

namespace eliminant::numeric {

/// A bivariate polynomial with rounded coefficients: coefficients(i, j) belongs to x^i y^j.
template <class Scalar>
struct BivariatePolynomial {
  Matrix<Scalar> coefficients;

  /// Ascending coefficients in y of the restriction to one x.
  Vector<std::complex<Scalar>> restrict_to(const std::complex<Scalar>& x) const {
    Vector<std::complex<Scalar>> result = Vector<std::complex<Scalar>>::Zero(coefficients.cols());
    for (long i = coefficients.rows(); i-- > 0;)
      for (long j = 0; j < coefficients.cols(); ++j) result(j) = result(j) * x + coefficients(i, j);
    return result;
  }
};

/// Value and both partial derivatives at a point.
template <class Scalar>
struct Jet {
  std::complex<Scalar> value, dx, dy;
};

/// Horner's rule in x inside Horner's rule in y.
template <class Scalar>
Jet<Scalar> jet(const BivariatePolynomial<Scalar>& p, const std::complex<Scalar>& x, const std::complex<Scalar>& y) {
  using Complex = std::complex<Scalar>;
  Jet<Scalar> result{Complex(Scalar(0)), Complex(Scalar(0)), Complex(Scalar(0))};
  for (long j = p.coefficients.cols(); j-- > 0;) {
    Complex row(Scalar(0));
    Complex row_dx(Scalar(0));
    for (long i = p.coefficients.rows(); i-- > 0;) {
      row_dx = row_dx * x + row;
      row = row * x + p.coefficients(i, j);
    }
    result.dy = result.dy * y + result.value;
    result.value = result.value * y + row;
    result.dx = result.dx * y + row_dx;
  }
  return result;
}

}  // namespace eliminant::numeric
