// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::symbolic {

/// A polynomial in Q[x_0, ..., x_(n-1)], sparse, terms in decreasing lexicographic order. The variables have no names
/// here; whoever reads or writes one keeps the list of names. Operands of a binary operation must have equal
/// variable_count(); otherwise InvalidInput is thrown.
class Polynomial {
 public:
  /// The zero polynomial in `variable_count` variables (at least 1).
  explicit Polynomial(std::size_t variable_count);
  static Polynomial constant(std::size_t variable_count, const Rational& value);
  /// x_index.
  static Polynomial variable(std::size_t variable_count, std::size_t index);

  struct Term {
    Rational coefficient;
    std::vector<unsigned long> exponents;  ///< one for each variable
  };
  /// The sum of the terms; repeated monomials are added.
  static Polynomial from_terms(std::size_t variable_count, std::span<const Term> terms);

  Polynomial(const Polynomial& other);
  Polynomial(Polynomial&& other) noexcept;
  Polynomial& operator=(const Polynomial& other);
  Polynomial& operator=(Polynomial&& other) noexcept;
  ~Polynomial();

  std::size_t variable_count() const { return variable_count_; }
  bool is_zero() const;
  bool is_constant() const;
  std::size_t term_count() const;
  /// Largest sum of exponents; -1 for the zero polynomial.
  long total_degree() const;
  /// Degree in x_index; -1 for the zero polynomial.
  long degree(std::size_t index) const;
  std::vector<Term> terms() const;
  /// The constant term.
  Rational constant_term() const;

  Polynomial derivative(std::size_t index) const;
  /// The composition with x_i = images[i]; all images have the same number of variables.
  Polynomial compose(std::span<const Polynomial> images) const;
  /// Divided by its content and with positive leading coefficient: the associate with coprime integer coefficients.
  Polynomial primitive_part() const;

  friend bool operator==(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Rational& scalar, const Polynomial& p);

  const fmpq_mpoly_struct* get() const { return value_; }
  fmpq_mpoly_struct* get() { return value_; }
  const fmpq_mpoly_ctx_struct* ring() const { return ring_; }

 private:
  std::size_t variable_count_;
  /// Shared by all polynomials in as many variables; never changed, never freed.
  const fmpq_mpoly_ctx_struct* ring_;
  fmpq_mpoly_t value_;
};

/// p^exponent.
Polynomial power(const Polynomial& p, unsigned long exponent);

/// a / b when b divides a exactly, InvalidInput otherwise (also for b = 0).
Polynomial exact_quotient(const Polynomial& a, const Polynomial& b);

/// In the grammar of parse_polynomial, for example `400*y^4 - 160*x^2*y^2 + 25/16`; `names` has variable_count()
/// entries. Terms by decreasing total degree, then lexicographically: reading the text back gives p.
std::string to_string(const Polynomial& p, std::span<const std::string> names);

}  // namespace eliminant::symbolic
