// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/bridge/rounding/round_matrix.hpp>

namespace eliminant::bridge {

namespace {

/// Largest bit length of a coefficient: dividing by this power of two puts the largest magnitude into [1/2, 1).
long largest_bit_length(const symbolic::PolynomialMatrix& matrix) {
  slong largest = 0;
  for (long i = 0; i < matrix.rows(); ++i)
    for (long j = 0; j < matrix.columns(); ++j)
      largest = std::max(largest, std::labs(fmpz_poly_max_bits(fmpz_poly_mat_entry(matrix.get(), i, j))));
  return largest;
}

template <class Scalar>
Scalar round(const arf_t value) {
  Scalar result;
  arf_get_mpfr(result.backend().data(), value, MPFR_RNDN);
  return result;
}

template <>
double round<double>(const arf_t value) {
  return arf_get_d(value, ARF_RND_NEAR);
}

template <class Scalar>
Scalar round_scaled(const fmpq_t value, long scale_log2) {
  // A quotient is rounded twice; 64 extra bits make the first rounding harmless (a half-way case needs more digits).
  arf_t scaled;
  arf_init(scaled);
  arf_t denominator;
  arf_init(denominator);
  arf_set_fmpz(scaled, fmpq_numref(value));
  arf_set_fmpz(denominator, fmpq_denref(value));
  arf_div(scaled, scaled, denominator, std::numeric_limits<Scalar>::digits + 64, ARF_RND_DOWN);
  arf_mul_2exp_si(scaled, scaled, -scale_log2);
  const Scalar result = round<Scalar>(scaled);
  arf_clear(denominator);
  arf_clear(scaled);
  return result;
}

template <class Scalar>
Scalar round_scaled(const fmpz_t value, long scale_log2) {
  arf_t scaled;
  arf_init(scaled);
  arf_set_fmpz(scaled, value);
  arf_mul_2exp_si(scaled, scaled, -scale_log2);
  const Scalar result = round<Scalar>(scaled);
  arf_clear(scaled);
  return result;
}

}  // namespace

template <class Scalar>
Rounded<numeric::MatrixPolynomial<Scalar>> round_matrix(const symbolic::PolynomialMatrix& matrix) {
  Rounded<numeric::MatrixPolynomial<Scalar>> result;
  result.scale_log2 = largest_bit_length(matrix);
  result.relative_error_bits = std::numeric_limits<Scalar>::digits;
  symbolic::Integer coefficient;
  for (long k = 0; k <= matrix.degree(); ++k) {
    numeric::Matrix<Scalar> rounded(matrix.rows(), matrix.columns());
    for (long i = 0; i < matrix.rows(); ++i)
      for (long j = 0; j < matrix.columns(); ++j) {
        fmpz_poly_get_coeff_fmpz(coefficient.get(), fmpz_poly_mat_entry(matrix.get(), i, j), k);
        rounded(i, j) = round_scaled<Scalar>(coefficient.get(), result.scale_log2);
      }
    result.value.coefficients.push_back(std::move(rounded));
  }
  return result;
}

template <class Scalar>
Rounded<numeric::BivariatePolynomial<Scalar>> round_polynomial(const symbolic::Polynomial& p) {
  Rounded<numeric::BivariatePolynomial<Scalar>> result;
  result.relative_error_bits = std::numeric_limits<Scalar>::digits;
  const auto terms = p.terms();
  bool first = true;
  for (const auto& term : terms) {
    const long magnitude = static_cast<long>(fmpz_bits(fmpq_numref(term.coefficient.get()))) -
                           static_cast<long>(fmpz_bits(fmpq_denref(term.coefficient.get()))) + 1;
    result.scale_log2 = first ? magnitude : std::max(result.scale_log2, magnitude);
    first = false;
  }
  result.value.coefficients = numeric::Matrix<Scalar>::Zero(p.degree(0) + 1, p.degree(1) + 1);
  for (const auto& term : terms)
    result.value.coefficients(static_cast<long>(term.exponents[0]), static_cast<long>(term.exponents[1])) =
        round_scaled<Scalar>(term.coefficient.get(), result.scale_log2);
  return result;
}

template Rounded<numeric::MatrixPolynomial<double>> round_matrix(const symbolic::PolynomialMatrix&);
template Rounded<numeric::MatrixPolynomial<numeric::Real128>> round_matrix(const symbolic::PolynomialMatrix&);
template Rounded<numeric::MatrixPolynomial<numeric::Real256>> round_matrix(const symbolic::PolynomialMatrix&);
template Rounded<numeric::MatrixPolynomial<numeric::Real512>> round_matrix(const symbolic::PolynomialMatrix&);
template Rounded<numeric::MatrixPolynomial<numeric::Real1024>> round_matrix(const symbolic::PolynomialMatrix&);
template Rounded<numeric::BivariatePolynomial<double>> round_polynomial(const symbolic::Polynomial&);
template Rounded<numeric::BivariatePolynomial<numeric::Real128>> round_polynomial(const symbolic::Polynomial&);
template Rounded<numeric::BivariatePolynomial<numeric::Real256>> round_polynomial(const symbolic::Polynomial&);
template Rounded<numeric::BivariatePolynomial<numeric::Real512>> round_polynomial(const symbolic::Polynomial&);
template Rounded<numeric::BivariatePolynomial<numeric::Real1024>> round_polynomial(const symbolic::Polynomial&);

}  // namespace eliminant::bridge
