// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/rational_inversion.hpp>

#include <algorithm>
#include <utility>

#include <eliminant/symbolic/elimination/exceptional_points.hpp>
#include <eliminant/symbolic/elimination/linear_relations.hpp>

namespace eliminant::symbolic {

namespace {

/// Sum of both degrees of the map: witnesses of quadratic quotients have twice that degree.
constexpr long largest_for_quadratic_quotients = 4;

/// All quotients of forms of one degree that give parameter `index`.
std::vector<ParameterQuotient> quotients(const RationalSurface& surface, std::size_t index, unsigned long degree) {
  const std::vector<Polynomial> forms = monomials_in_space(degree);
  std::vector<Polynomial> on_surface;
  for (const Polynomial& form : forms) on_surface.push_back(form.compose(surface.coordinates()));
  std::vector<Polynomial> products;
  for (const Polynomial& value : on_surface) products.push_back(value * Polynomial::variable(2, index));
  products.insert(products.end(), on_surface.begin(), on_surface.end());
  std::vector<ParameterQuotient> result;
  for (const std::vector<Integer>& relation : linear_relations(products)) {
    const auto middle = relation.begin() + static_cast<long>(forms.size());
    ParameterQuotient found;
    found.denominator = linear_combination({relation.begin(), middle}, forms);
    found.numerator = Rational(-1) * linear_combination({middle, relation.end()}, forms);
    if (!found.denominator.compose(surface.coordinates()).is_zero()) result.push_back(std::move(found));
  }
  return result;
}

/// By quotients of the least degree.
std::vector<ParameterQuotient> quotients(const RationalSurface& surface, std::size_t index) {
  const auto [m, n] = surface.bidegree();
  const unsigned long largest = m + n <= largest_for_quadratic_quotients ? 2 : 1;
  std::vector<ParameterQuotient> result;
  for (unsigned long degree = 1; degree <= largest && result.empty(); ++degree)
    result = quotients(surface, index, degree);
  return result;
}

/// G with p = G q modulo the equation, up to a constant factor; nullopt when there is none.
std::optional<Polynomial> quotient_modulo(const Polynomial& p, const Polynomial& q, const Polynomial& equation) {
  const long degree = p.total_degree() - q.total_degree();
  if (degree < 0) return std::nullopt;
  const std::vector<Polynomial> forms = monomials_in_space(static_cast<unsigned long>(degree));
  std::vector<Polynomial> columns{p};
  for (const Polynomial& form : forms) columns.push_back(form * q);
  const long rest = p.total_degree() - equation.total_degree();
  if (rest >= 0)
    for (const Polynomial& form : monomials_in_space(static_cast<unsigned long>(rest)))
      columns.push_back(form * equation);
  for (const std::vector<Integer>& relation : linear_relations(columns)) {
    if (Rational(relation.front()).is_zero()) continue;
    return linear_combination({relation.begin() + 1, relation.begin() + 1 + static_cast<long>(forms.size())}, forms);
  }
  return std::nullopt;
}

/// The weight of the surface where its parameters are these quotients.
Polynomial weight_at(const RationalSurface& surface, const ParameterQuotient& s, const ParameterQuotient& t) {
  const auto [m, n] = surface.bidegree();
  Polynomial sum(4);
  for (const auto& term : surface.coordinates()[3].terms()) {
    const unsigned long i = term.exponents[0];
    const unsigned long j = term.exponents[1];
    sum = sum + term.coefficient * (power(s.numerator, i) * power(s.denominator, static_cast<unsigned long>(m) - i) *
                                    power(t.numerator, j) * power(t.denominator, static_cast<unsigned long>(n) - j));
  }
  return sum;
}

/// Some combination of the witnesses is a power of w modulo the equation.
bool cover_affine_space(const std::vector<Polynomial>& witnesses, const Polynomial& equation) {
  const Polynomial w = Polynomial::variable(4, 3);
  long degree = 0;
  for (const Polynomial& witness : witnesses) degree = std::max(degree, witness.total_degree());
  std::vector<Polynomial> columns{power(w, static_cast<unsigned long>(degree))};
  for (const Polynomial& witness : witnesses)
    for (const Polynomial& form : monomials_in_space(static_cast<unsigned long>(degree - witness.total_degree())))
      columns.push_back(form * witness);
  const long rest = degree - equation.total_degree();
  if (rest >= 0)
    for (const Polynomial& form : monomials_in_space(static_cast<unsigned long>(rest)))
      columns.push_back(form * equation);
  const auto found = linear_relations(columns);
  return std::any_of(found.begin(), found.end(),
                     [](const auto& relation) { return !Rational(relation.front()).is_zero(); });
}

/// With the same zeros on the surface: each of these forms that divides it modulo the equation only once. Closer
/// to linear near its zeros, so that less precision tells what is not zero.
Polynomial with_simple_factors(Polynomial witness, const std::vector<ParameterQuotient>& quotients,
                               const Polynomial& equation) {
  Polynomial simple = Polynomial::constant(4, 1);
  for (const ParameterQuotient& q : quotients)
    for (const Polynomial* form : {&q.denominator, &q.numerator}) {
      bool divides = false;
      while (!form->is_zero()) {
        const auto rest = quotient_modulo(witness, *form, equation);
        if (!rest) break;
        witness = *rest;
        divides = true;
      }
      if (divides) simple = simple * *form;
    }
  return witness * simple;
}

}  // namespace

std::optional<Polynomial> low_equation(const RationalSurface& surface, unsigned long largest_degree) {
  for (unsigned long degree = 1; degree <= largest_degree; ++degree) {
    const std::vector<Polynomial> forms = monomials_in_space(degree);
    std::vector<Polynomial> on_surface;
    for (const Polynomial& form : forms) on_surface.push_back(form.compose(surface.coordinates()));
    const auto found = linear_relations(on_surface);
    if (found.size() > 1) return std::nullopt;
    if (found.size() == 1) return linear_combination(found.front(), forms);
  }
  return std::nullopt;
}

bool RationalInversion::is_inverse_everywhere() const {
  return std::any_of(witnesses.begin(), witnesses.end(), [](const Polynomial& g) { return g.is_constant(); });
}

std::optional<RationalInversion> rational_inversion(const RationalSurface& surface) {
  if (surface.kind() != RationalSurface::Kind::tensor_product || surface.coordinates()[3].is_zero())
    return std::nullopt;
  const std::optional<Polynomial> equation = low_equation(surface);
  if (!equation) return std::nullopt;
  RationalInversion result;
  result.equation = *equation;
  for (const std::size_t index : {0U, 1U}) {
    result.parameters[index] = quotients(surface, index);
    if (result.parameters[index].empty()) return std::nullopt;
  }
  const Polynomial w = Polynomial::variable(4, 3);
  for (const ParameterQuotient& s : result.parameters[0])
    for (const ParameterQuotient& t : result.parameters[1]) {
      std::optional<Polynomial> g = quotient_modulo(weight_at(surface, s, t), w, result.equation);
      if (!g || quotient_modulo(*g, result.equation, result.equation)) continue;
      while (const auto divided = quotient_modulo(*g, w, result.equation)) g = divided;
      result.witnesses.push_back(with_simple_factors(*std::move(g), {s, t}, result.equation));
    }
  if (result.witnesses.empty()) return std::nullopt;
  if (!result.is_inverse_everywhere() && cover_affine_space(result.witnesses, result.equation))
    result.witnesses.assign(1, Polynomial::constant(4, 1));
  result.exceptions_are_lines =
      result.is_inverse_everywhere() || are_exceptions_contracted_lines(surface, result.equation, result.witnesses);
  return result;
}

}  // namespace eliminant::symbolic
