// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <numeric>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

namespace {

void require_same_ring(const Polynomial& a, const Polynomial& b) {
  if (a.variable_count() != b.variable_count())
    throw InvalidInput("polynomials in " + std::to_string(a.variable_count()) + " and " +
                           std::to_string(b.variable_count()) + " variables were combined",
                       "the same variables");
}

/// FLINT's description of the ring in so many variables: immutable, made once. Making one for each polynomial took
/// longer than the arithmetic on small ones.
const fmpq_mpoly_ctx_struct* shared_ring(std::size_t variable_count) {
  constexpr std::size_t most_variables = 16;
  using Rings = std::array<fmpq_mpoly_ctx_struct, most_variables + 1>;
  static const Rings rings = [] {
    Rings made{};
    for (std::size_t n = 0; n < made.size(); ++n) fmpq_mpoly_ctx_init(&made[n], static_cast<slong>(n), ORD_LEX);
    return made;
  }();
  if (variable_count > most_variables)
    throw InvalidInput("a polynomial in " + std::to_string(variable_count) + " variables",
                       "at most " + std::to_string(most_variables) + " variables");
  return &rings[variable_count];
}

}  // namespace

Polynomial::Polynomial(std::size_t variable_count)
    : variable_count_(variable_count), ring_(shared_ring(variable_count)) {
  fmpq_mpoly_init(value_, ring_);
}

Polynomial Polynomial::constant(std::size_t variable_count, const Rational& value) {
  Polynomial result(variable_count);
  fmpq_mpoly_set_fmpq(result.value_, value.get(), result.ring_);
  return result;
}

Polynomial Polynomial::variable(std::size_t variable_count, std::size_t index) {
  Polynomial result(variable_count);
  fmpq_mpoly_gen(result.value_, static_cast<slong>(index), result.ring_);
  return result;
}

Polynomial Polynomial::from_terms(std::size_t variable_count, std::span<const Term> terms) {
  Polynomial result(variable_count);
  for (const Term& term : terms) {
    if (term.exponents.size() != variable_count)
      throw InvalidInput("a term has " + std::to_string(term.exponents.size()) + " exponents",
                         std::to_string(variable_count) + " exponents");
    fmpq_mpoly_push_term_fmpq_ui(result.value_, term.coefficient.get(), term.exponents.data(), result.ring_);
  }
  fmpq_mpoly_sort_terms(result.value_, result.ring_);
  fmpq_mpoly_combine_like_terms(result.value_, result.ring_);
  return result;
}

Polynomial::Polynomial(const Polynomial& other) : Polynomial(other.variable_count_) {
  fmpq_mpoly_set(value_, other.value_, ring_);
}

Polynomial::Polynomial(Polynomial&& other) noexcept : Polynomial(other.variable_count_) {
  fmpq_mpoly_swap(value_, other.value_, ring_);
}

Polynomial& Polynomial::operator=(const Polynomial& other) {
  if (this != &other) *this = Polynomial(other);
  return *this;
}

Polynomial& Polynomial::operator=(Polynomial&& other) noexcept {
  std::swap(variable_count_, other.variable_count_);
  std::swap(ring_, other.ring_);
  std::swap(*value_, *other.value_);
  return *this;
}

Polynomial::~Polynomial() { fmpq_mpoly_clear(value_, ring_); }

bool Polynomial::is_zero() const { return fmpq_mpoly_is_zero(value_, ring_) != 0; }

bool Polynomial::is_constant() const { return fmpq_mpoly_is_fmpq(value_, ring_) != 0; }

std::size_t Polynomial::term_count() const { return static_cast<std::size_t>(fmpq_mpoly_length(value_, ring_)); }

long Polynomial::total_degree() const { return fmpq_mpoly_total_degree_si(value_, ring_); }

long Polynomial::degree(std::size_t index) const {
  return fmpq_mpoly_degree_si(value_, static_cast<slong>(index), ring_);
}

std::vector<Polynomial::Term> Polynomial::terms() const {
  std::vector<Term> result(term_count());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i].exponents.resize(variable_count_);
    fmpq_mpoly_get_term_coeff_fmpq(result[i].coefficient.get(), value_, static_cast<slong>(i), ring_);
    fmpq_mpoly_get_term_exp_ui(result[i].exponents.data(), value_, static_cast<slong>(i), ring_);
  }
  return result;
}

Rational Polynomial::constant_term() const {
  Rational result;
  const std::vector<unsigned long> zero(variable_count_, 0);
  fmpq_mpoly_get_coeff_fmpq_ui(result.get(), value_, zero.data(), ring_);
  return result;
}

Polynomial Polynomial::derivative(std::size_t index) const {
  Polynomial result(variable_count_);
  fmpq_mpoly_derivative(result.value_, value_, static_cast<slong>(index), ring_);
  return result;
}

Polynomial Polynomial::compose(std::span<const Polynomial> images) const {
  if (images.size() != variable_count_)
    throw InvalidInput("a substitution names " + std::to_string(images.size()) + " variables",
                       std::to_string(variable_count_) + " images");
  const std::size_t target = images.front().variable_count();
  // Powers of each image are shared by all terms.
  std::vector<std::vector<Polynomial>> powers(variable_count_);
  for (std::size_t i = 0; i < variable_count_; ++i) {
    require_same_ring(images.front(), images[i]);
    powers[i].push_back(Polynomial::constant(target, 1));
    for (long k = 1; k <= degree(i); ++k) powers[i].push_back(powers[i].back() * images[i]);
  }
  Polynomial sum(target);
  for (const Term& term : terms()) {
    Polynomial product = Polynomial::constant(target, term.coefficient);
    for (std::size_t i = 0; i < variable_count_; ++i) product = product * powers[i][term.exponents[i]];
    sum = sum + product;
  }
  return sum;
}

Polynomial Polynomial::primitive_part() const {
  if (is_zero()) return *this;
  Rational content;
  fmpq_mpoly_content(content.get(), value_, ring_);
  Rational leading;
  fmpq_mpoly_get_term_coeff_fmpq(leading.get(), value_, 0, ring_);
  if (leading.sign() * content.sign() < 0) content = -content;
  return (Rational(1) / content) * *this;
}

bool operator==(const Polynomial& a, const Polynomial& b) {
  return a.variable_count_ == b.variable_count_ && fmpq_mpoly_equal(a.value_, b.value_, a.ring_) != 0;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  require_same_ring(a, b);
  Polynomial sum(a.variable_count_);
  fmpq_mpoly_add(sum.value_, a.value_, b.value_, sum.ring_);
  return sum;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  require_same_ring(a, b);
  Polynomial difference(a.variable_count_);
  fmpq_mpoly_sub(difference.value_, a.value_, b.value_, difference.ring_);
  return difference;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  require_same_ring(a, b);
  Polynomial product(a.variable_count_);
  fmpq_mpoly_mul(product.value_, a.value_, b.value_, product.ring_);
  return product;
}

Polynomial operator*(const Rational& scalar, const Polynomial& p) {
  Polynomial product(p.variable_count_);
  fmpq_mpoly_scalar_mul_fmpq(product.value_, p.value_, scalar.get(), product.ring_);
  return product;
}

Polynomial power(const Polynomial& p, unsigned long exponent) {
  Polynomial result(p.variable_count());
  if (fmpq_mpoly_pow_ui(result.get(), p.get(), exponent, result.ring()) == 0)
    throw LimitReached("a power of a polynomial is too large to expand");
  return result;
}

Polynomial exact_quotient(const Polynomial& a, const Polynomial& b) {
  require_same_ring(a, b);
  if (b.is_zero()) throw InvalidInput("division by the zero polynomial", "a non-zero divisor");
  Polynomial quotient(a.variable_count());
  if (fmpq_mpoly_divides(quotient.get(), a.get(), b.get(), quotient.ring()) == 0)
    throw InvalidInput("a polynomial is not a multiple of its divisor", "an exact division");
  return quotient;
}

std::string to_string(const Polynomial& p, std::span<const std::string> names) {
  if (p.is_zero()) return "0";
  std::vector<Polynomial::Term> terms = p.terms();
  const auto total = [](const Polynomial::Term& t) {
    return std::accumulate(t.exponents.begin(), t.exponents.end(), 0UL);
  };
  std::stable_sort(terms.begin(), terms.end(), [&](const auto& a, const auto& b) { return total(a) > total(b); });
  std::string text;
  for (const Polynomial::Term& term : terms) {
    const bool negative = term.coefficient.sign() < 0;
    if (text.empty())
      text += negative ? "-" : "";
    else
      text += negative ? " - " : " + ";
    const Rational magnitude = negative ? -term.coefficient : term.coefficient;
    std::string monomial;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (term.exponents[i] == 0) continue;
      if (!monomial.empty()) monomial += "*";
      monomial += names[i];
      if (term.exponents[i] > 1) monomial += "^" + std::to_string(term.exponents[i]);
    }
    if (monomial.empty())
      text += magnitude.to_string();
    else
      text += magnitude == Rational(1) ? monomial : magnitude.to_string() + "*" + monomial;
  }
  return text;
}

}  // namespace eliminant::symbolic
