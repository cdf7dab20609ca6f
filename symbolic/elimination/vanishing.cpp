// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/vanishing.hpp>

#include <algorithm>
#include <map>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

namespace {

using Exponents = std::vector<unsigned long>;

struct IntegerTerm {
  Integer coefficient;
  Exponents exponents;
};
using IntegerTerms = std::vector<IntegerTerm>;

IntegerTerms integer_terms(const Polynomial& p) {
  IntegerTerms result;
  for (const Polynomial::Term& term : p.terms()) result.push_back({term.coefficient.numerator(), term.exponents});
  return result;
}

Integer norm(const IntegerTerms& terms) {
  Integer sum;
  Integer magnitude;
  for (const IntegerTerm& term : terms) {
    fmpz_abs(magnitude.get(), term.coefficient.get());
    sum = sum + magnitude;
  }
  return sum;
}

/// The powers x^0, ..., x^highest.
std::vector<mp_limb_t> powers(const PrimeField& field, mp_limb_t x, unsigned long highest) {
  std::vector<mp_limb_t> result{1};
  for (unsigned long e = 1; e <= highest; ++e) result.push_back(field.multiply(result.back(), x));
  return result;
}

/// A form modulo a prime, made for many values: a multiplication for each term.
class ModularForm {
 public:
  ModularForm(const IntegerTerms& terms, unsigned long degree, const PrimeField& field)
      : field_(field), degree_(degree) {
    std::map<Exponents, std::vector<Term>> groups;
    for (const IntegerTerm& term : terms) {
      const std::size_t last = term.exponents.size() - 1;
      groups[Exponents(term.exponents.begin(), term.exponents.end() - 2)].push_back(
          {field.reduce(term.coefficient), term.exponents[last - 1], term.exponents[last]});
    }
    groups_.assign(groups.begin(), groups.end());
  }

  mp_limb_t at(const std::vector<mp_limb_t>& point) const {
    std::vector<std::vector<mp_limb_t>> table;
    for (const mp_limb_t x : point) table.push_back(powers(field_, x, degree_));
    const std::vector<mp_limb_t>& first = table[table.size() - 2];
    const std::vector<mp_limb_t>& second = table.back();
    const std::size_t side = degree_ + 1;
    std::vector<mp_limb_t> products(side * side);
    for (std::size_t i = 0; i < side; ++i)
      for (std::size_t j = 0; i + j < side; ++j) products[i * side + j] = field_.multiply(first[i], second[j]);
    mp_limb_t sum = 0;
    for (const auto& [exponents, terms] : groups_) {
      mp_limb_t inner = 0;
      for (const Term& term : terms)
        inner = field_.add(inner, field_.multiply(term.coefficient, products[term.first * side + term.second]));
      for (std::size_t k = 0; k < exponents.size(); ++k) inner = field_.multiply(inner, table[k][exponents[k]]);
      sum = field_.add(sum, inner);
    }
    return sum;
  }

 private:
  struct Term {
    mp_limb_t coefficient;
    unsigned long first;
    unsigned long second;
  };
  const PrimeField& field_;
  unsigned long degree_;
  std::vector<std::pair<Exponents, std::vector<Term>>> groups_;
};

/// The coordinates of a map as polynomials in one or two affine parameters, and where F(f) is to be evaluated.
struct AffineMap {
  std::vector<IntegerTerms> coordinates;
  /// Degrees in each parameter, or of both together: the points 0, ..., degree in each direction, those of the triangle
  /// alone when `triangular`.
  std::vector<unsigned long> degrees;
  bool triangular = false;
};

mp_limb_t value_of(const IntegerTerms& terms, const std::vector<std::vector<mp_limb_t>>& parameter_powers,
                   const PrimeField& field) {
  mp_limb_t sum = 0;
  for (const IntegerTerm& term : terms) {
    mp_limb_t product = field.reduce(term.coefficient);
    for (std::size_t k = 0; k < parameter_powers.size(); ++k)
      product = field.multiply(product, parameter_powers[k][term.exponents[k]]);
    sum = field.add(sum, product);
  }
  return sum;
}

bool vanishes_modulo(const ModularForm& form, unsigned long form_degree, const AffineMap& map,
                     const PrimeField& field) {
  const bool plane = map.degrees.size() == 2;
  const unsigned long first_end = map.degrees[0] * form_degree;
  const unsigned long second_end = plane ? map.degrees[1] * form_degree : 0;
  std::vector<std::vector<mp_limb_t>> parameter_powers(map.degrees.size());
  std::vector<mp_limb_t> point(map.coordinates.size());
  for (unsigned long i = 0; i <= first_end; ++i) {
    parameter_powers[0] = powers(field, i, map.degrees[0]);
    for (unsigned long j = 0; j <= (map.triangular ? first_end - i : second_end); ++j) {
      if (plane) parameter_powers[1] = powers(field, j, map.degrees[1]);
      for (std::size_t k = 0; k < point.size(); ++k) point[k] = value_of(map.coordinates[k], parameter_powers, field);
      if (form.at(point) != 0) return false;
    }
  }
  return true;
}

bool vanishes_on(const Polynomial& given, const AffineMap& map, const Context& context) {
  if (given.variable_count() != map.coordinates.size() || !is_form(given))
    throw InvalidInput("a polynomial is to vanish on a map that is no form in its coordinates",
                       "a form in " + std::to_string(map.coordinates.size()) + " variables");
  if (given.is_zero()) return true;
  const Polynomial primitive = given.primitive_part();
  const auto degree = static_cast<unsigned long>(primitive.total_degree());
  const IntegerTerms form = integer_terms(primitive);
  Integer largest;
  for (const IntegerTerms& coordinate : map.coordinates)
    if (const Integer own = norm(coordinate); fmpz_cmp(own.get(), largest.get()) > 0) largest = own;
  // The coefficients of F(f) are at most |F|_1 max |f_k|_1^degree.
  const unsigned long bits_needed = (norm(form) * power(largest, degree)).bit_length() + 1;
  PrimeSequence primes(0);
  for (unsigned long bits = 0; bits < bits_needed; bits += 61) {
    context.checkpoint("check of the equation");
    const PrimeField field(primes.next());
    if (!vanishes_modulo(ModularForm(form, degree, field), degree, map, field)) return false;
  }
  return true;
}

}  // namespace

bool vanishes_on(const Polynomial& form, const RationalCurve& curve, const Context& context) {
  AffineMap map;
  map.degrees = {static_cast<unsigned long>(curve.degree())};
  for (const UnivariatePolynomial& f : curve.coordinates()) {
    IntegerTerms& terms = map.coordinates.emplace_back();
    for (long i = 0; i <= f.degree(); ++i) terms.push_back({f.coefficient(i), {static_cast<unsigned long>(i)}});
  }
  return vanishes_on(form, map, context);
}

bool vanishes_on(const Polynomial& form, const RationalSurface& surface, const Context& context) {
  AffineMap map;
  map.triangular = surface.kind() == RationalSurface::Kind::triangular;
  // Of the homogeneous parameters the last one is 1.
  if (map.triangular)
    map.degrees.assign(2, static_cast<unsigned long>(surface.degree()));
  else
    for (const long degree : surface.bidegree()) map.degrees.push_back(static_cast<unsigned long>(degree));
  for (const Polynomial& f : surface.coordinates()) map.coordinates.push_back(integer_terms(f));
  return vanishes_on(form, map, context);
}

}  // namespace eliminant::symbolic
