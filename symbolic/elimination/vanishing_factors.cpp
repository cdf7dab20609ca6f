// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/vanishing_factors.hpp>

#include <algorithm>

#include <eliminant/symbolic/arithmetic/rational_univariate.hpp>

namespace eliminant::symbolic {

namespace {

/// Arithmetic modulo one polynomial.
class Residues {
 public:
  explicit Residues(const UnivariatePolynomial& modulus) : modulus_(modulus) {}

  RationalUnivariate product(const RationalUnivariate& a, const RationalUnivariate& b) const {
    RationalUnivariate result;
    fmpq_poly_mul(result.get(), a.get(), b.get());
    fmpq_poly_rem(result.get(), result.get(), modulus_.get());
    return result;
  }
  /// 1, a, ..., a^highest.
  std::vector<RationalUnivariate> powers(const RationalUnivariate& a, unsigned long highest) const {
    std::vector<RationalUnivariate> result;
    fmpq_poly_one(result.emplace_back().get());
    for (unsigned long e = 1; e <= highest; ++e) result.push_back(product(result.back(), a));
    return result;
  }

 private:
  RationalUnivariate modulus_;
};

}  // namespace

std::vector<UnivariatePolynomial> vanishing_factors(const UnivariateRepresentation& representation,
                                                    const Polynomial& q) {
  std::vector<UnivariatePolynomial> result;
  for (const SquarefreeFactor& part : representation.classes) {
    const Residues residues(part.factor);
    // y = -n / d and x = (t d + s n) / d; everything times d to the total degree.
    RationalUnivariate n(representation.numerator);
    RationalUnivariate d(representation.denominator);
    fmpq_poly_scalar_mul_si(d.get(), d.get(), static_cast<slong>(part.multiplicity));
    RationalUnivariate x = d;
    fmpq_poly_shift_left(x.get(), x.get(), 1);
    RationalUnivariate sheared = n;
    fmpq_poly_scalar_mul_si(sheared.get(), sheared.get(), representation.shear);
    fmpq_poly_add(x.get(), x.get(), sheared.get());
    fmpq_poly_neg(n.get(), n.get());
    const auto degree = static_cast<unsigned long>(std::max(q.total_degree(), 0L));
    const std::vector<RationalUnivariate> x_powers = residues.powers(x, degree);
    const std::vector<RationalUnivariate> y_powers = residues.powers(n, degree);
    const std::vector<RationalUnivariate> d_powers = residues.powers(d, degree);
    RationalUnivariate sum;
    for (const Polynomial::Term& term : q.terms()) {
      RationalUnivariate product = residues.product(x_powers[term.exponents[0]], y_powers[term.exponents[1]]);
      product = residues.product(product, d_powers[degree - term.exponents[0] - term.exponents[1]]);
      fmpq_poly_scalar_mul_fmpq(product.get(), product.get(), term.coefficient.get());
      fmpq_poly_add(sum.get(), sum.get(), product.get());
    }
    result.push_back(gcd(part.factor, sum.numerator()));
  }
  return result;
}

}  // namespace eliminant::symbolic
