// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/matrices/sylvester_matrix.hpp>

namespace eliminant::symbolic {

PolynomialMatrix sylvester_matrix(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g) {
  if (f.degree() < 0 || g.degree() < 0)
    throw InvalidInput("the Sylvester matrix of a zero polynomial was asked for", "two non-zero polynomials");
  const long m = f.degree();
  const long n = g.degree();
  PolynomialMatrix result(m + n, m + n);
  for (long shift = 0; shift < n; ++shift)
    for (long k = 0; k <= m; ++k) result.set_entry(shift + k, shift, f.coefficients[static_cast<std::size_t>(k)]);
  for (long shift = 0; shift < m; ++shift)
    for (long k = 0; k <= n; ++k) result.set_entry(shift + k, n + shift, g.coefficients[static_cast<std::size_t>(k)]);
  return result;
}

}  // namespace eliminant::symbolic
