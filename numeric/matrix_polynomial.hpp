// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/numeric/scalar.hpp>

namespace eliminant::numeric {

/// T(x) = T_0 + T_1 x + ... + T_m x^m with square coefficients of one size; at least one coefficient.
template <class Scalar>
struct MatrixPolynomial {
  std::vector<Matrix<Scalar>> coefficients;

  long size() const { return coefficients.front().rows(); }
  long degree() const { return static_cast<long>(coefficients.size()) - 1; }

  /// T(x) at a complex number, by Horner's rule.
  Matrix<std::complex<Scalar>> evaluate(const std::complex<Scalar>& x) const {
    Matrix<std::complex<Scalar>> sum = coefficients.back().template cast<std::complex<Scalar>>();
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
      for (long i = 0; i < sum.size(); ++i) sum(i) = sum(i) * x + coefficients[k](i);
    }
    return sum;
  }
};

}  // namespace eliminant::numeric
