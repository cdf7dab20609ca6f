// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::symbolic {

UnivariatePolynomial::UnivariatePolynomial(const std::vector<Integer>& coefficients) : UnivariatePolynomial() {
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    fmpz_poly_set_coeff_fmpz(value_, static_cast<slong>(i), coefficients[i].get());
}

UnivariatePolynomial UnivariatePolynomial::with_root(const Rational& root) {
  return UnivariatePolynomial({-root.numerator(), root.denominator()});
}

Integer UnivariatePolynomial::coefficient(long exponent) const {
  Integer result;
  fmpz_poly_get_coeff_fmpz(result.get(), value_, exponent);
  return result;
}

UnivariatePolynomial UnivariatePolynomial::derivative() const {
  UnivariatePolynomial result;
  fmpz_poly_derivative(result.value_, value_);
  return result;
}

UnivariatePolynomial UnivariatePolynomial::primitive_part() const {
  UnivariatePolynomial result;
  fmpz_poly_primitive_part(result.value_, value_);
  return result;
}

UnivariatePolynomial operator+(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
  UnivariatePolynomial sum;
  fmpz_poly_add(sum.value_, a.value_, b.value_);
  return sum;
}

UnivariatePolynomial operator-(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
  UnivariatePolynomial difference;
  fmpz_poly_sub(difference.value_, a.value_, b.value_);
  return difference;
}

UnivariatePolynomial operator*(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
  UnivariatePolynomial product;
  fmpz_poly_mul(product.value_, a.value_, b.value_);
  return product;
}

UnivariatePolynomial power(const UnivariatePolynomial& p, unsigned long exponent) {
  UnivariatePolynomial result;
  fmpz_poly_pow(result.get(), p.get(), exponent);
  return result;
}

UnivariatePolynomial gcd(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
  UnivariatePolynomial result;
  fmpz_poly_gcd(result.get(), a.get(), b.get());
  return result.primitive_part();
}

bool has_real_root(const UnivariatePolynomial& p) {
  if (p.degree() < 1) return false;
  UnivariatePolynomial squarefree;
  fmpz_poly_div(squarefree.get(), p.get(), gcd(p, p.derivative()).get());
  return fmpz_poly_num_real_roots(squarefree.get()) > 0;
}

}  // namespace eliminant::symbolic
