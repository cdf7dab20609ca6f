// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/symbolic/elimination/chow_form.hpp>

namespace eliminant::symbolic {

namespace {

Integer leading_form_at(const Polynomial& p, long shear) {
  const auto degree = static_cast<unsigned long>(p.total_degree());
  Integer sum;
  for (const auto& term : p.terms())
    if (term.exponents[0] + term.exponents[1] == degree)
      sum = sum + term.coefficient.numerator() * power(Integer(-shear), term.exponents[0]);
  return sum;
}

/// Sum over j of (1-norm in t and epsilon of the coefficient of y^j of p(t - (s + epsilon) y, y))^2.
Integer squared_row_norm(const Polynomial& p, long shear) {
  std::vector<Integer> norms(static_cast<std::size_t>(p.total_degree()) + 1);
  const Integer slope(std::labs(shear) + 1);
  for (const auto& term : p.terms()) {
    Integer magnitude = term.coefficient.numerator();
    fmpz_abs(magnitude.get(), magnitude.get());
    Integer binomial;
    for (unsigned long k = 0; k <= term.exponents[0]; ++k) {
      fmpz_bin_uiui(binomial.get(), term.exponents[0], k);
      Integer& norm = norms[term.exponents[1] + k];
      norm = norm + magnitude * binomial * power(slope, k);
    }
  }
  Integer sum;
  for (const Integer& norm : norms) sum = sum + norm * norm;
  return sum;
}

/// A bound on the bit length of every coefficient of C and of its derivative with respect to s.
unsigned long coefficient_bits(const Polynomial& p, const Polynomial& q, long shear) {
  const Integer squared = power(squared_row_norm(p, shear), static_cast<unsigned long>(q.total_degree())) *
                          power(squared_row_norm(q, shear), static_cast<unsigned long>(p.total_degree()));
  return squared.bit_length() / 2 + 1;
}

/// Incremental Chinese remaindering of polynomials of a fixed length.
class Reconstruction {
 public:
  void add(const ModularPolynomial& image, mp_limb_t prime) {
    if (first_) {
      fmpz_poly_set_nmod_poly(value_.get(), image.get());
      modulus_ = Integer();
      fmpz_set_ui(modulus_.get(), prime);
      first_ = false;
      return;
    }
    fmpz_poly_CRT_ui(value_.get(), value_.get(), modulus_.get(), image.get(), 1);
    fmpz_mul_ui(modulus_.get(), modulus_.get(), prime);
  }
  UnivariatePolynomial take() { return std::move(value_); }

 private:
  UnivariatePolynomial value_;
  Integer modulus_;
  bool first_ = true;
};

}  // namespace

ModularCurve::ModularCurve(const Polynomial& p, const PrimeField& field) : field_(field), degree_(p.total_degree()) {
  by_x_power_.resize(static_cast<std::size_t>(std::max(p.degree(0), 0L)) + 1);
  for (const auto& term : p.terms()) {
    auto& row = by_x_power_[term.exponents[0]];
    row.resize(std::max<std::size_t>(row.size(), term.exponents[1] + 1), 0);
    row[term.exponents[1]] = field.reduce(term.coefficient.numerator());
  }
}

mp_limb_t ModularCurve::leading_form_at(mp_limb_t s) const {
  mp_limb_t sum = 0;
  for (std::size_t i = by_x_power_.size(); i-- > 0;) {
    sum = field_.multiply(sum, field_.negate(s));
    const auto j = static_cast<std::size_t>(degree_) - i;
    if (j < by_x_power_[i].size()) sum = field_.add(sum, by_x_power_[i][j]);
  }
  return sum;
}

void ModularCurve::restrict_to_line(mp_limb_t t, mp_limb_t s, ModularPolynomial& restriction) const {
  // Horner's rule in x = t - s y, on coefficient vectors in y.
  const auto length = static_cast<std::size_t>(degree_) + 1;
  nmod_poly_fit_length(restriction.get(), static_cast<slong>(length));
  mp_limb_t* const r = restriction.get()->coeffs;
  std::fill(r, r + length, 0);
  const mp_limb_t minus_s = field_.negate(s);
  for (std::size_t i = by_x_power_.size(); i-- > 0;) {
    const std::size_t used = length - i;  // degree in y of the partial sum is at most degree - i
    if (s == 0) {
      for (std::size_t j = 0; j < used; ++j) r[j] = field_.multiply(r[j], t);
    } else {
      for (std::size_t j = used; j-- > 1;)
        r[j] = field_.add(field_.multiply(r[j], t), field_.multiply(r[j - 1], minus_s));
      r[0] = field_.multiply(r[0], t);
    }
    const auto& row = by_x_power_[i];
    for (std::size_t j = 0; j < row.size(); ++j) r[j] = field_.add(r[j], row[j]);
  }
  restriction.get()->length = static_cast<slong>(length);
  _nmod_poly_normalise(restriction.get());
}

void ModularCurve::restrict_to_line(mp_limb_t t, mp_limb_t s, ModularPolynomial& restriction,
                                    ModularPolynomial& derivative) const {
  const auto length = static_cast<std::size_t>(degree_) + 1;
  nmod_poly_fit_length(restriction.get(), static_cast<slong>(length));
  nmod_poly_fit_length(derivative.get(), static_cast<slong>(length));
  mp_limb_t* const r = restriction.get()->coeffs;
  mp_limb_t* const d = derivative.get()->coeffs;
  std::fill(r, r + length, 0);
  std::fill(d, d + length, 0);
  const mp_limb_t minus_s = field_.negate(s);
  for (std::size_t i = by_x_power_.size(); i-- > 0;) {
    const std::size_t used = length - i;
    // d <- d (t - s y) + r, then r <- r (t - s y) + row: the derivative with respect to x.
    for (std::size_t j = used; j-- > 0;) {
      const mp_limb_t lower_d = j > 0 ? field_.multiply(d[j - 1], minus_s) : 0;
      const mp_limb_t lower_r = j > 0 ? field_.multiply(r[j - 1], minus_s) : 0;
      d[j] = field_.add(field_.add(field_.multiply(d[j], t), lower_d), r[j]);
      r[j] = field_.add(field_.multiply(r[j], t), lower_r);
    }
    const auto& row = by_x_power_[i];
    for (std::size_t j = 0; j < row.size(); ++j) r[j] = field_.add(r[j], row[j]);
  }
  // d = p_x(t - s y, y), of degree < length - 1; the derivative with respect to s is -y d.
  for (std::size_t j = length; j-- > 1;) d[j] = field_.negate(d[j - 1]);
  d[0] = 0;
  restriction.get()->length = static_cast<slong>(length);
  derivative.get()->length = static_cast<slong>(length);
  _nmod_poly_normalise(restriction.get());
  _nmod_poly_normalise(derivative.get());
}

std::optional<ModularChowForm> chow_form_modulo(const ModularCurve& p, const ModularCurve& q, mp_limb_t s,
                                                bool with_derivative, const PrimeField& field) {
  // The curve whose restriction keeps its full degree on every line x + s y = t plays the first part.
  const bool swapped = p.leading_form_at(s) == 0;
  const ModularCurve& f = swapped ? q : p;
  const ModularCurve& g = swapped ? p : q;
  const mp_limb_t leading = f.leading_form_at(s);
  if (leading == 0) return std::nullopt;
  const mp_limb_t inverse_leading = field.inverse(leading);

  const auto point_count = static_cast<std::size_t>(f.degree() * g.degree()) + 1;
  std::vector<mp_limb_t> points;
  std::vector<mp_limb_t> values;
  std::vector<mp_limb_t> derivatives;
  ModularPolynomial f0(field), f1(field), g0(field), g1(field), cofactor_f(field), cofactor_g(field), divisor(field);
  ModularPolynomial numerator(field), product(field);
  for (mp_limb_t t = 0; points.size() < point_count; ++t) {
    if (with_derivative) {
      f.restrict_to_line(t, s, f0, f1);
      g.restrict_to_line(t, s, g0, g1);
    } else {
      f.restrict_to_line(t, s, f0);
      g.restrict_to_line(t, s, g0);
    }
    mp_limb_t value = g0.is_zero() ? (f.degree() == 0 ? 1 : 0) : nmod_poly_resultant(f0.get(), g0.get());
    if (!g0.is_zero())  // from the true degree of g to the formal one
      value = field.multiply(value, field.power(leading, static_cast<unsigned long>(g.degree() - g0.degree())));
    if (with_derivative) {
      if (value == 0) continue;  // the logarithmic derivative below needs another point
      // With the roots y_i of f: d log Res(f, g) = deg(g) d log lc(f) + sum of (g1 - g0' f1 / f0')(y_i) / g0(y_i), and
      // the sum of h(y_i) / f0'(y_i) is the coefficient of y^(deg f - 1) in h mod f, over lc(f) (Euler, Jacobi).
      mp_limb_t logarithmic = 0;
      if (f.degree() > 0) {
        nmod_poly_xgcd(divisor.get(), cofactor_f.get(), cofactor_g.get(), f0.get(), g0.get());
        nmod_poly_derivative(numerator.get(), f0.get());
        nmod_poly_mul(numerator.get(), numerator.get(), g1.get());
        nmod_poly_derivative(product.get(), g0.get());
        nmod_poly_mul(product.get(), product.get(), f1.get());
        nmod_poly_sub(numerator.get(), numerator.get(), product.get());
        nmod_poly_rem(numerator.get(), numerator.get(), f0.get());
        nmod_poly_mul(numerator.get(), numerator.get(), cofactor_g.get());
        nmod_poly_rem(numerator.get(), numerator.get(), f0.get());
        const mp_limb_t sum = nmod_poly_get_coeff_ui(numerator.get(), f.degree() - 1);
        const mp_limb_t scale = field.inverse(nmod_poly_get_coeff_ui(divisor.get(), 0));
        logarithmic = field.multiply(field.multiply(sum, scale), inverse_leading);
        const mp_limb_t leading_rate = field.multiply(nmod_poly_get_coeff_ui(f1.get(), f.degree()), inverse_leading);
        logarithmic = field.add(logarithmic, field.multiply(leading_rate, field.reduce(g.degree())));
      }
      derivatives.push_back(field.multiply(value, logarithmic));
    }
    points.push_back(t);
    values.push_back(value);
  }
  ModularChowForm result{interpolate(field, points, std::move(values)), std::nullopt};
  if (with_derivative) result.shear_derivative = interpolate(field, std::move(points), std::move(derivatives));
  return result;
}

bool is_admissible_shear(const Polynomial& p, const Polynomial& q, long shear) {
  return !leading_form_at(p, shear).is_zero() || !leading_form_at(q, shear).is_zero();
}

ChowForm chow_form(const Polynomial& p, const Polynomial& q, long shear, bool with_derivative, std::uint64_t seed,
                   const Context& context) {
  // The part of f must be played by the same curve for every prime, because exchanging them may change the sign.
  const bool swapped = leading_form_at(p, shear).is_zero();
  const Polynomial& f = swapped ? q : p;
  const Polynomial& g = swapped ? p : q;
  if (leading_form_at(f, shear).is_zero())
    throw InvalidInput("the shear " + std::to_string(shear) + " is the direction of a common point at infinity",
                       "an admissible shear");
  const unsigned long bits_needed = coefficient_bits(f, g, shear) + 1;
  PrimeSequence primes(seed);
  Reconstruction form;
  Reconstruction derivative;
  for (unsigned long bits = 0; bits < bits_needed;) {
    context.checkpoint("elimination");
    const PrimeField field(primes.next());
    const ModularCurve modular_f(f, field);
    if (modular_f.leading_form_at(field.reduce(shear)) == 0) continue;
    const auto image = chow_form_modulo(modular_f, ModularCurve(g, field), field.reduce(shear), with_derivative, field);
    form.add(image->form, field.prime());
    if (with_derivative) derivative.add(*image->shear_derivative, field.prime());
    bits += 61;
  }
  return {form.take(), derivative.take(), shear};
}

}  // namespace eliminant::symbolic
