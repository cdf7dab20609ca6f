// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/linear_inversion.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>

namespace eliminant::symbolic {

namespace {

constexpr unsigned long largest_degree = 4;

/// All coefficients are integers here.
Integer integer_of(const Rational& value) { return value.numerator(); }

/// The vectors c with sum c_i p_i = 0, one in each entry.
std::vector<std::vector<Integer>> relations(const std::vector<Polynomial>& p) {
  std::map<std::vector<unsigned long>, long> rows;
  for (const Polynomial& one : p)
    for (const auto& term : one.terms()) rows.emplace(term.exponents, static_cast<long>(rows.size()));
  IntegerMatrix system(static_cast<long>(rows.size()), static_cast<long>(p.size()));
  for (std::size_t j = 0; j < p.size(); ++j)
    for (const auto& term : p[j].terms())
      fmpz_set(system.entry(rows.at(term.exponents), static_cast<long>(j)), integer_of(term.coefficient).get());
  const IntegerMatrix kernel = nullspace(system);
  std::vector<std::vector<Integer>> result;
  for (long k = 0; k < kernel.columns(); ++k) {
    std::vector<Integer> vector;
    for (long i = 0; i < kernel.rows(); ++i) vector.emplace_back(kernel.entry(i, k));
    result.push_back(std::move(vector));
  }
  return result;
}

/// The monomials of one degree in x, y, z, w.
std::vector<Polynomial> monomials(unsigned long degree) {
  std::vector<Polynomial> result;
  for (unsigned long i = 0; i <= degree; ++i)
    for (unsigned long j = 0; i + j <= degree; ++j)
      for (unsigned long k = 0; i + j + k <= degree; ++k) {
        const std::array<Polynomial::Term, 1> term{{{Rational(1), {i, j, k, degree - i - j - k}}}};
        result.push_back(Polynomial::from_terms(4, term));
      }
  return result;
}

Polynomial combination(const std::vector<Integer>& c, const std::vector<Polynomial>& p) {
  Polynomial sum(p.front().variable_count());
  for (std::size_t i = 0; i < p.size(); ++i) sum = sum + Rational(c[i]) * p[i];
  return sum;
}

/// The form of least degree that vanishes on the surface.
std::optional<Polynomial> low_equation(const RationalSurface& surface) {
  for (unsigned long degree = 1; degree <= largest_degree; ++degree) {
    const std::vector<Polynomial> forms = monomials(degree);
    std::vector<Polynomial> on_surface;
    for (const Polynomial& form : forms) on_surface.push_back(form.compose(surface.coordinates()));
    const auto found = relations(on_surface);
    if (found.size() > 1) return std::nullopt;
    if (found.size() == 1) return combination(found.front(), forms);
  }
  return std::nullopt;
}

/// All quotients of linear forms that give parameter `index`.
std::vector<LinearParameter> quotients(const RationalSurface& surface, std::size_t index) {
  const std::vector<Polynomial>& x = surface.coordinates();
  std::vector<Polynomial> products;
  for (const Polynomial& coordinate : x) products.push_back(coordinate * Polynomial::variable(2, index));
  products.insert(products.end(), x.begin(), x.end());
  std::vector<LinearParameter> result;
  for (const std::vector<Integer>& relation : relations(products)) {
    LinearParameter found;
    for (std::size_t i = 0; i < 4; ++i) {
      found.denominator = found.denominator + Rational(relation[i]) * Polynomial::variable(4, i);
      found.numerator = found.numerator - Rational(relation[i + 4]) * Polynomial::variable(4, i);
    }
    if (!found.denominator.compose(x).is_zero()) result.push_back(std::move(found));
  }
  return result;
}

/// G with p = G q modulo the equation, up to a constant factor; nullopt when there is none.
std::optional<Polynomial> quotient_modulo(const Polynomial& p, const Polynomial& q, const Polynomial& equation) {
  const long degree = p.total_degree() - q.total_degree();
  if (degree < 0) return std::nullopt;
  const std::vector<Polynomial> forms = monomials(static_cast<unsigned long>(degree));
  std::vector<Polynomial> columns{p};
  for (const Polynomial& form : forms) columns.push_back(form * q);
  const long rest = p.total_degree() - equation.total_degree();
  if (rest >= 0)
    for (const Polynomial& form : monomials(static_cast<unsigned long>(rest))) columns.push_back(form * equation);
  for (const std::vector<Integer>& relation : relations(columns)) {
    if (Rational(relation.front()).is_zero()) continue;
    return combination({relation.begin() + 1, relation.begin() + 1 + static_cast<long>(forms.size())}, forms);
  }
  return std::nullopt;
}

/// The weight of the surface where its parameters are these quotients.
Polynomial weight_at(const RationalSurface& surface, const LinearParameter& s, const LinearParameter& t) {
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
    for (const Polynomial& form : monomials(static_cast<unsigned long>(degree - witness.total_degree())))
      columns.push_back(form * witness);
  const long rest = degree - equation.total_degree();
  if (rest >= 0)
    for (const Polynomial& form : monomials(static_cast<unsigned long>(rest))) columns.push_back(form * equation);
  const auto found = relations(columns);
  return std::any_of(found.begin(), found.end(),
                     [](const auto& relation) { return !Rational(relation.front()).is_zero(); });
}

/// With the same zeros on the surface: each of these linear forms that divides it modulo the equation only once. Closer
/// to linear near its zeros, so that less precision tells what is not zero.
Polynomial with_simple_factors(Polynomial witness, const std::vector<LinearParameter>& quotients,
                               const Polynomial& equation) {
  Polynomial simple = Polynomial::constant(4, 1);
  for (const LinearParameter& q : quotients)
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

bool LinearInversion::is_inverse_everywhere() const {
  return std::any_of(witnesses.begin(), witnesses.end(), [](const Polynomial& g) { return g.is_constant(); });
}

std::optional<LinearInversion> linear_inversion(const RationalSurface& surface) {
  if (surface.kind() != RationalSurface::Kind::tensor_product || surface.coordinates()[3].is_zero())
    return std::nullopt;
  LinearInversion result;
  for (const std::size_t index : {0U, 1U}) {
    result.parameters[index] = quotients(surface, index);
    if (result.parameters[index].empty()) return std::nullopt;
  }
  const std::optional<Polynomial> equation = low_equation(surface);
  if (!equation) return std::nullopt;
  result.equation = *equation;
  const Polynomial w = Polynomial::variable(4, 3);
  for (const LinearParameter& s : result.parameters[0])
    for (const LinearParameter& t : result.parameters[1]) {
      std::optional<Polynomial> g = quotient_modulo(weight_at(surface, s, t), w, result.equation);
      if (!g || quotient_modulo(*g, result.equation, result.equation)) continue;
      while (const auto divided = quotient_modulo(*g, w, result.equation)) g = divided;
      result.witnesses.push_back(with_simple_factors(*std::move(g), {s, t}, result.equation));
    }
  if (result.witnesses.empty()) return std::nullopt;
  if (!result.is_inverse_everywhere() && cover_affine_space(result.witnesses, result.equation))
    result.witnesses.assign(1, Polynomial::constant(4, 1));
  return result;
}

}  // namespace eliminant::symbolic
