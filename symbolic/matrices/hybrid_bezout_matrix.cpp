// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/matrices/hybrid_bezout_matrix.hpp>

namespace eliminant::symbolic {

PolynomialMatrix hybrid_bezout_matrix(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g, long m,
                                      long n) {
  if (m < n || n < 1 || f.degree() > m || g.degree() > n)
    throw InvalidInput(
        "the hybrid Bezout matrix of degrees " + std::to_string(m) + " and " + std::to_string(n) + " was asked for",
        "formal degrees m >= n >= 1, at least the degrees of the polynomials");
  const UnivariatePolynomial zero;
  const auto coefficient = [&](const HiddenVariablePolynomial& p, long k) -> const UnivariatePolynomial& {
    return k >= 0 && k <= p.degree() ? p.coefficients[static_cast<std::size_t>(k)] : zero;
  };
  PolynomialMatrix result(m, m);
  UnivariatePolynomial product;
  // Coefficient of e^j in row i: the sum over r <= i of a_(m-i+r) b_(j-r-m+n) - b_(n-i+r) a_(j-r). The part of degree
  // >= m cancels. Row i follows from row i - 1 shifted by one power of e.
  for (long i = 0; i < n; ++i)
    for (long j = 0; j < m; ++j) {
      fmpz_poly_struct* const entry = fmpz_poly_mat_entry(result.get(), i, j);
      if (i > 0 && j > 0) fmpz_poly_set(entry, fmpz_poly_mat_entry(result.get(), i - 1, j - 1));
      fmpz_poly_mul(product.get(), coefficient(f, m - i).get(), coefficient(g, j - m + n).get());
      fmpz_poly_add(entry, entry, product.get());
      fmpz_poly_mul(product.get(), coefficient(g, n - i).get(), coefficient(f, j).get());
      fmpz_poly_sub(entry, entry, product.get());
    }
  for (long s = 0; s < m - n; ++s)
    for (long k = 0; k <= g.degree(); ++k) result.set_entry(n + s, s + k, coefficient(g, k));
  return result;
}

}  // namespace eliminant::symbolic
