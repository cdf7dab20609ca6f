// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/curve_meetings.hpp>

#include <algorithm>

namespace eliminant::symbolic {

namespace {

using Point = std::array<mp_limb_t, 4>;
using Coordinates = std::array<ModularPolynomial, 4>;

/// Numbers that look random, one after the other.
class Numbers {
 public:
  Numbers(const PrimeField& field, std::uint64_t seed) : prime_(field.prime()), seed_(seed) {}
  mp_limb_t next() { return mix(seed_, index_++) % prime_; }

 private:
  mp_limb_t prime_;
  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

/// v = (a x + b) / (c x + d): infinity becomes a general parameter like all others.
struct ChangeOfParameter {
  mp_limb_t a, b, c, d;
  explicit ChangeOfParameter(Numbers& numbers)
      : a(numbers.next()), b(numbers.next()), c(numbers.next()), d(numbers.next()) {}
  mp_limb_t preimage(mp_limb_t v, const PrimeField& field) const {
    return field.multiply(field.subtract(field.multiply(d, v), b),
                          field.inverse(field.subtract(a, field.multiply(c, v))));
  }
};

ModularPolynomial linear(mp_limb_t slope, mp_limb_t constant, const PrimeField& field) {
  ModularPolynomial result(field);
  nmod_poly_set_coeff_ui(result.get(), 1, slope);
  nmod_poly_set_coeff_ui(result.get(), 0, constant);
  return result;
}

Coordinates changed(const ModularSpaceCurve& curve, const ChangeOfParameter& change, const PrimeField& field) {
  const std::size_t degree = curve.size() - 1;
  const ModularPolynomial numerator = linear(change.a, change.b, field);
  const ModularPolynomial denominator = linear(change.c, change.d, field);
  Coordinates result{ModularPolynomial(field), ModularPolynomial(field), ModularPolynomial(field),
                     ModularPolynomial(field)};
  ModularPolynomial monomial(field);
  ModularPolynomial other(field);
  for (std::size_t j = 0; j <= degree; ++j) {
    nmod_poly_pow(monomial.get(), numerator.get(), j);
    nmod_poly_pow(other.get(), denominator.get(), degree - j);
    nmod_poly_mul(monomial.get(), monomial.get(), other.get());
    for (std::size_t k = 0; k < 4; ++k) {
      nmod_poly_scalar_mul_nmod(other.get(), monomial.get(), curve[j][k]);
      nmod_poly_add(result[k].get(), result[k].get(), other.get());
    }
  }
  return result;
}

long degree_of(const Coordinates& curve) {
  long degree = -1;
  for (const ModularPolynomial& coordinate : curve) degree = std::max(degree, coordinate.degree());
  return degree;
}

/// Divides common zeros out; whether there were any.
bool divide_base_points_out(Coordinates& curve, const PrimeField& field) {
  ModularPolynomial common(field);
  for (const ModularPolynomial& coordinate : curve) nmod_poly_gcd(common.get(), common.get(), coordinate.get());
  if (common.degree() < 1) return false;
  for (ModularPolynomial& coordinate : curve) nmod_poly_div(coordinate.get(), coordinate.get(), common.get());
  return true;
}

Point value_at(const Coordinates& curve, mp_limb_t x) {
  Point point{};
  for (std::size_t k = 0; k < 4; ++k) point[k] = nmod_poly_evaluate_nmod(curve[k].get(), x);
  return point;
}

/// An alternating form on pairs of points: zero where the two are equal.
class AlternatingForm {
 public:
  AlternatingForm(const PrimeField& field, Numbers& numbers) : field_(field) {
    for (mp_limb_t& weight : weights_) weight = numbers.next();
  }
  /// The linear form that `point` in the first place makes.
  Point contracted(const Point& point) const {
    Point result{};
    std::size_t index = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j, ++index) {
        result[j] = field_.add(result[j], field_.multiply(weights_[index], point[i]));
        result[i] = field_.subtract(result[i], field_.multiply(weights_[index], point[j]));
      }
    return result;
  }

 private:
  PrimeField field_;
  std::array<mp_limb_t, 6> weights_{};
};

ModularPolynomial combination(const Coordinates& curve, const Point& weights, const PrimeField& field) {
  ModularPolynomial result(field);
  ModularPolynomial product(field);
  for (std::size_t k = 0; k < 4; ++k) {
    nmod_poly_scalar_mul_nmod(product.get(), curve[k].get(), weights[k]);
    nmod_poly_add(result.get(), result.get(), product.get());
  }
  return result;
}

/// The parameters of `curve` at which it is `point`.
ModularPolynomial parameters_of(const Point& point, const Coordinates& curve, const PrimeField& field,
                                Numbers& numbers) {
  ModularPolynomial common(field);
  for (int k = 0; k < 3; ++k)
    nmod_poly_gcd(common.get(), common.get(),
                  combination(curve, AlternatingForm(field, numbers).contracted(point), field).get());
  return common;
}

/// The resultant of two random forms in the parameter of the second curve, in that of the first.
ModularPolynomial random_eliminant(const Coordinates& first, const Coordinates& second, const PrimeField& field,
                                   Numbers& numbers) {
  const AlternatingForm f(field, numbers);
  const AlternatingForm g(field, numbers);
  const long n = degree_of(first);
  const long m = degree_of(second);
  std::vector<mp_limb_t> points;
  std::vector<mp_limb_t> values;
  while (static_cast<long>(points.size()) <= 2 * n * m) {
    const mp_limb_t x = numbers.next();
    const Point point = value_at(first, x);
    const ModularPolynomial f_at = combination(second, f.contracted(point), field);
    const ModularPolynomial g_at = combination(second, g.contracted(point), field);
    // Of the formal degree both, so that the resultant is a polynomial in x.
    if (f_at.degree() < m || g_at.degree() < m) continue;
    if (std::find(points.begin(), points.end(), x) != points.end()) continue;
    points.push_back(x);
    values.push_back(nmod_poly_resultant(f_at.get(), g_at.get()));
  }
  return interpolate(field, std::move(points), std::move(values));
}

/// Divides all powers of x - root out.
void remove_root(ModularPolynomial& p, mp_limb_t root, const PrimeField& field) {
  const ModularPolynomial factor = linear(1, field.negate(root), field);
  while (p.degree() > 0 && nmod_poly_evaluate_nmod(p.get(), root) == 0) nmod_poly_div(p.get(), p.get(), factor.get());
}

ModularPolynomial squarefree_part(const ModularPolynomial& p, const PrimeField& field) {
  ModularPolynomial derivative(field);
  nmod_poly_derivative(derivative.get(), p.get());
  nmod_poly_gcd(derivative.get(), derivative.get(), p.get());
  ModularPolynomial result(field);
  nmod_poly_div(result.get(), p.get(), derivative.get());
  return result;
}

/// The characteristic polynomial of f / g on the roots of p.
std::vector<mp_limb_t> ratios_on_roots(const ModularPolynomial& p, const ModularPolynomial& f,
                                       const ModularPolynomial& g, const PrimeField& field) {
  std::vector<mp_limb_t> points;
  std::vector<mp_limb_t> values;
  ModularPolynomial difference(field);
  for (mp_limb_t z = 0; static_cast<long>(points.size()) <= p.degree(); ++z) {
    nmod_poly_scalar_mul_nmod(difference.get(), g.get(), z);
    nmod_poly_sub(difference.get(), difference.get(), f.get());
    // The remainder has the same values on the roots; powers of the leading coefficient of p do not depend on z.
    nmod_poly_rem(difference.get(), difference.get(), p.get());
    points.push_back(z);
    mp_limb_t value = 0;
    if (!difference.is_zero()) {
      value = nmod_poly_resultant(p.get(), difference.get());
      const mp_limb_t leading = nmod_poly_get_coeff_ui(p.get(), p.degree());
      value = field.multiply(value, field.power(leading, static_cast<unsigned long>(p.degree() - difference.degree())));
    }
    values.push_back(value);
  }
  ModularPolynomial result = interpolate(field, std::move(points), std::move(values));
  if (!result.is_zero()) nmod_poly_make_monic(result.get(), result.get());
  std::vector<mp_limb_t> coefficients;
  for (long k = 0; k <= result.degree(); ++k) coefficients.push_back(nmod_poly_get_coeff_ui(result.get(), k));
  return coefficients;
}

}  // namespace

CurveMeetings curve_meetings(const ModularSpaceCurve& first, const ModularSpaceCurve& second,
                             const std::optional<TrivialPair>& trivial, const PrimeField& field, std::uint64_t seed,
                             std::uint64_t projection_seed) {
  Numbers numbers(field, seed);
  const ChangeOfParameter first_change(numbers);
  const ChangeOfParameter second_change(numbers);
  Coordinates a = changed(first, first_change, field);
  Coordinates c = changed(second, second_change, field);
  CurveMeetings result;
  result.first_has_base_point = divide_base_points_out(a, field);
  result.second_has_base_point = divide_base_points_out(c, field);
  const mp_limb_t x = trivial ? first_change.preimage(trivial->first, field) : 0;
  const mp_limb_t y = trivial ? second_change.preimage(trivial->second, field) : 0;

  // A polynomial whose roots are the parameters of the first curve at the common points.
  ModularPolynomial meetings(field);
  const bool first_is_point = degree_of(a) < 1;
  if (first_is_point || degree_of(c) < 1) {
    meetings = first_is_point ? parameters_of(value_at(a, 0), c, field, numbers)
                              : parameters_of(value_at(c, 0), a, field, numbers);
    if (!meetings.is_zero() && trivial) remove_root(meetings, first_is_point ? y : x, field);
    // All of them are one point; any parameter that is none of the trivial ones stands for it.
    if (first_is_point && meetings.degree() > 0) meetings = linear(1, numbers.next(), field);
  } else {
    ModularPolynomial eliminant = random_eliminant(a, c, field, numbers);
    nmod_poly_gcd(meetings.get(), eliminant.get(), random_eliminant(a, c, field, numbers).get());
    if (!meetings.is_zero() && trivial) {
      remove_root(meetings, x, field);
      ModularPolynomial others = parameters_of(value_at(a, x), c, field, numbers);
      remove_root(others, y, field);
      if (others.degree() > 0) nmod_poly_mul(meetings.get(), meetings.get(), linear(1, field.negate(x), field).get());
    }
  }
  if (meetings.is_zero()) {
    // Two equal points are the trivial pair and nothing else.
    result.infinite = !trivial || degree_of(a) > 0 || degree_of(c) > 0;
    return result;
  }
  if (meetings.degree() < 1) return result;
  meetings = squarefree_part(meetings, field);
  ModularPolynomial weightless(field);
  nmod_poly_gcd(weightless.get(), meetings.get(), a[0].get());
  result.at_infinity = weightless.degree();
  result.finite = meetings.degree() - result.at_infinity;
  Numbers projection(field, projection_seed);
  Point f{};
  Point g{};
  for (std::size_t k = 0; k < 4; ++k) {
    f[k] = projection.next();
    g[k] = projection.next();
  }
  result.images = ratios_on_roots(meetings, combination(a, f, field), combination(a, g, field), field);
  result.parameters = ratios_on_roots(meetings, linear(first_change.a, first_change.b, field),
                                      linear(first_change.c, first_change.d, field), field);
  result.infinite_parameters = !first_is_point && result.parameters.size() == 1;
  return result;
}

}  // namespace eliminant::symbolic
