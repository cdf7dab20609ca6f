// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/arithmetic/rational_univariate.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <eliminant/symbolic/elimination/fibre_gcd.hpp>
#include <eliminant/symbolic/elimination/univariate_representation.hpp>

namespace eliminant::symbolic {

namespace {

UnivariatePolynomial exact_quotient(const UnivariatePolynomial& a, const UnivariatePolynomial& b) {
  UnivariatePolynomial quotient;
  fmpz_poly_div(quotient.get(), a.get(), b.get());
  return quotient;
}

/// The k-th Taylor coefficient in y of f at y = a, modulo h: sum over j of binomial(j, k) f_j a^(j-k).
RationalUnivariate taylor_coefficient(const HiddenVariablePolynomial& f, unsigned long k, const RationalUnivariate& a,
                                      const RationalUnivariate& h) {
  RationalUnivariate sum;
  Integer binomial;
  for (std::size_t j = f.coefficients.size(); j-- > k;) {
    fmpq_poly_mul(sum.get(), sum.get(), a.get());
    fmpz_bin_uiui(binomial.get(), j, k);
    RationalUnivariate coefficient(f.coefficients[j]);
    fmpq_poly_scalar_mul_fmpz(coefficient.get(), coefficient.get(), binomial.get());
    fmpq_poly_add(sum.get(), sum.get(), coefficient.get());
    fmpq_poly_rem(sum.get(), sum.get(), h.get());
  }
  return sum;
}

/// y(t) modulo h for the class of multiplicity k; nullopt when the denominator shares a root with h (it never does for
/// a squarefree part of the Chow form).
RationalUnivariate coordinate_modulo(const UnivariateRepresentation& representation, unsigned long multiplicity,
                                     const UnivariatePolynomial& h) {
  const RationalUnivariate modulus(h);
  RationalUnivariate denominator(representation.denominator);
  fmpq_poly_scalar_mul_si(denominator.get(), denominator.get(), -static_cast<long>(multiplicity));
  fmpq_poly_rem(denominator.get(), denominator.get(), modulus.get());
  RationalUnivariate divisor, inverse, unused;
  fmpq_poly_xgcd(divisor.get(), inverse.get(), unused.get(), denominator.get(), modulus.get());
  RationalUnivariate y(representation.numerator);
  fmpq_poly_rem(y.get(), y.get(), modulus.get());
  fmpq_poly_mul(y.get(), y.get(), inverse.get());
  fmpq_poly_rem(y.get(), y.get(), modulus.get());
  return y;
}

/// The sum over the roots t of the class of the largest e such that (y - y(t))^e divides both restrictions.
unsigned long proven_fibre_degree(const UnivariateRepresentation& representation, const SquarefreeFactor& part,
                                  const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g,
                                  const Context& context) {
  const RationalUnivariate y = coordinate_modulo(representation, part.multiplicity, part.factor);
  UnivariatePolynomial remaining = part.factor;  // its roots: the fibres whose order exceeds k
  unsigned long sum = 0;
  for (unsigned long k = 0; remaining.degree() > 0; ++k) {
    context.checkpoint("proving the shear generic");
    RationalUnivariate y_reduced(y);
    const RationalUnivariate modulus(remaining);
    fmpq_poly_rem(y_reduced.get(), y_reduced.get(), modulus.get());
    for (const HiddenVariablePolynomial* curve : {&f, &g}) {
      const RationalUnivariate value = taylor_coefficient(*curve, k, y_reduced, modulus);
      if (!value.is_zero()) remaining = gcd(remaining, value.numerator());
    }
    sum += static_cast<unsigned long>(remaining.degree());
  }
  return sum;
}

bool separates(const UnivariateRepresentation& representation, const HiddenVariablePolynomial& f,
               const HiddenVariablePolynomial& g, std::uint64_t seed, const Context& context) {
  PrimeSequence primes(mix(seed, 3));
  for (const SquarefreeFactor& part : representation.classes) {
    if (part.multiplicity == 1) continue;
    context.checkpoint("proving the shear generic");
    std::optional<unsigned long> upper_bound;
    for (int attempt = 0; attempt < 4 && !upper_bound; ++attempt)
      upper_bound = fibre_gcd_degree_modulo(f, g, part.factor, PrimeField(primes.next()));
    if (!upper_bound) return false;
    // Every root of the Chow form has a solution above it, so a sum of the number of roots means degree 1 everywhere.
    if (*upper_bound == static_cast<unsigned long>(part.factor.degree())) continue;
    if (proven_fibre_degree(representation, part, f, g, context) != *upper_bound) return false;
  }
  return true;
}

}  // namespace

unsigned long UnivariateRepresentation::with_multiplicity() const {
  unsigned long sum = 0;
  for (const auto& part : classes) sum += part.multiplicity * static_cast<unsigned long>(part.factor.degree());
  return sum;
}

unsigned long UnivariateRepresentation::distinct() const {
  unsigned long sum = 0;
  for (const auto& part : classes) sum += static_cast<unsigned long>(part.factor.degree());
  return sum;
}

std::optional<UnivariateRepresentation> univariate_representation(const Polynomial& p, const Polynomial& q, long s,
                                                                  std::uint64_t seed, const Context& context) {
  const ChowForm chow = chow_form(p, q, s, true, seed, context);
  UnivariateRepresentation representation;
  representation.shear = s;
  if (chow.form.degree() < 1) return representation;
  representation.classes = squarefree_decomposition(chow.form);
  UnivariatePolynomial squarefree_part(std::vector<Integer>{Integer(1)});
  for (const auto& part : representation.classes) squarefree_part = squarefree_part * part.factor;
  // G up to the content of C, which moves to the denominator: only a primitive divisor keeps the quotient integral.
  const UnivariatePolynomial repeated = exact_quotient(chow.form, squarefree_part);
  Integer content;
  fmpz_poly_content(content.get(), repeated.get());
  if (fmpz_sgn(fmpz_poly_lead(repeated.get())) < 0) content = -content;
  representation.numerator = exact_quotient(chow.shear_derivative, repeated.primitive_part());
  representation.denominator = squarefree_part.derivative();
  fmpz_poly_scalar_mul_fmpz(representation.denominator.get(), representation.denominator.get(), content.get());
  const HiddenVariablePolynomial f = hide_variable(shear(p, Rational(s)), 0);
  const HiddenVariablePolynomial g = hide_variable(shear(q, Rational(s)), 0);
  if (!separates(representation, f, g, seed, context)) return std::nullopt;
  return representation;
}

}  // namespace eliminant::symbolic
