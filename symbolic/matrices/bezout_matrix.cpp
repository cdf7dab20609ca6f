// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/matrices/bezout_matrix.hpp>

namespace eliminant::symbolic {

PolynomialMatrix bezout_matrix(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g) {
  if (f.degree() < 0 || g.degree() < 0)
    throw InvalidInput("the Bezout matrix of a zero polynomial was asked for", "two non-zero polynomials");
  const long size = std::max(f.degree(), g.degree());
  const auto coefficient = [](const HiddenVariablePolynomial& p, long k) {
    return k <= p.degree() ? p.coefficients[static_cast<std::size_t>(k)] : UnivariatePolynomial();
  };
  // The numerator is the sum over m > n of (f_m g_n - g_m f_n)(u^m v^n - u^n v^m), and the last factor divided by u - v
  // is (uv)^n times the sum of all u^a v^b with a + b = m - n - 1.
  PolynomialMatrix result(size, size);
  for (long i = 0; i < size; ++i) {
    for (long j = i; j < size; ++j) {
      UnivariatePolynomial sum;
      for (long n = std::max(0L, i + j + 1 - size); n <= i; ++n) {
        const long m = i + j + 1 - n;
        sum = sum + (coefficient(f, m) * coefficient(g, n) - coefficient(g, m) * coefficient(f, n));
      }
      result.set_entry(i, j, sum);
      result.set_entry(j, i, sum);
    }
  }
  return result;
}

}  // namespace eliminant::symbolic
