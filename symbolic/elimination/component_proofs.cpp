// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/component_proofs.hpp>

#include <array>
#include <optional>
#include <vector>

#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>

namespace eliminant::symbolic {

namespace {

bool divides(const Polynomial& f, const Polynomial& g) {
  Polynomial quotient(2);
  return fmpq_mpoly_divides(quotient.get(), g.get(), f.get(), g.ring()) != 0;
}

/// The kernel of the matrix modulo f as polynomials, where it has dimension one.
class KernelOnComponent {
 public:
  KernelOnComponent(const SeparatedBezoutian& matrix, const Polynomial& f, std::uint64_t seed, const Context& context)
      : matrix_(matrix), f_(f), seed_(seed), context_(context) {
    for (row_ = 0; row_ < matrix.size(); ++row_)
      if (!divides(f, cofactor(row_))) return;
  }
  bool found() const { return row_ < matrix_.size(); }

  /// Values of the monomial s^i v^j.
  Polynomial value(std::size_t i, std::size_t j) const { return cofactor(i * matrix_.first_degree() + j); }

  /// Two multiples of (1, v), not both zero on f = 0; nullopt when v is not among the monomials.
  std::optional<std::array<Polynomial, 2>> first_parameter() const { return neighbours(true); }
  /// The same for (1, s).
  std::optional<std::array<Polynomial, 2>> second_parameter() const { return neighbours(false); }

 private:
  Polynomial cofactor(std::size_t column) const {
    const Polynomial value = minor(matrix_, without(row_), without(column), seed_, context_);
    return (row_ + column) % 2 == 0 ? value : Rational(-1) * value;
  }

  std::vector<std::size_t> without(std::size_t index) const {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < matrix_.size(); ++k)
      if (k != index) result.push_back(k);
    return result;
  }

  std::optional<std::array<Polynomial, 2>> neighbours(bool in_v) const {
    const std::size_t di = in_v ? 0 : 1;
    const std::size_t dj = in_v ? 1 : 0;
    for (std::size_t i = 0; i + di < matrix_.second_degree(); ++i)
      for (std::size_t j = 0; j + dj < matrix_.first_degree(); ++j) {
        std::array<Polynomial, 2> pair{value(i, j), value(i + di, j + dj)};
        if (!divides(f_, pair[0]) || !divides(f_, pair[1])) return pair;
      }
    return std::nullopt;
  }

  const SeparatedBezoutian& matrix_;
  const Polynomial& f_;
  std::uint64_t seed_;
  const Context& context_;
  std::size_t row_ = 0;
};

/// The coefficients of the powers of variable `index`, the other variable at place `kept` of two.
std::vector<Polynomial> coefficients(const Polynomial& p, std::size_t index, long degree, std::size_t kept) {
  std::vector<Polynomial> result(static_cast<std::size_t>(degree) + 1, Polynomial(2));
  for (const Polynomial::Term& term : p.terms()) {
    std::vector<unsigned long> exponents(2, 0);
    exponents[kept] = term.exponents[1 - index];
    Polynomial& sum = result[term.exponents[index]];
    sum = sum + Polynomial::from_terms(2, std::vector<Polynomial::Term>{{term.coefficient, std::move(exponents)}});
  }
  return result;
}

/// sum of c_j x^j y^(n - j) for (y, x).
Polynomial form_at(const std::vector<Polynomial>& c, const std::array<Polynomial, 2>& parameter) {
  const std::size_t n = c.size() - 1;
  Polynomial sum(2);
  for (std::size_t j = 0; j <= n; ++j) sum = sum + c[j] * power(parameter[1], j) * power(parameter[0], n - j);
  return sum;
}

/// The point at infinity of the line A_0 + v A_1: three coordinates.
std::array<Polynomial, 3> point_at_infinity(const RationalSurface& surface, std::size_t index, std::size_t kept) {
  const std::vector<Polynomial> weight = coefficients(surface.coordinates()[3], index, 1, kept);
  std::array<Polynomial, 3> result{Polynomial(2), Polynomial(2), Polynomial(2)};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<Polynomial> c = coefficients(surface.coordinates()[k], index, 1, kept);
    result[k] = c[0] * weight[1] - c[1] * weight[0];
  }
  return result;
}

/// Two lines whose points at infinity are equal on f = 0 and not both lines at infinity.
bool lines_meet_at_infinity(const RationalSurface& first, const RationalSurface& second, const Polynomial& f) {
  const std::array<Polynomial, 3> p = point_at_infinity(first, 1, 0);
  const std::array<Polynomial, 3> q = point_at_infinity(second, 0, 1);
  bool first_is_point = false;
  bool second_is_point = false;
  for (std::size_t k = 0; k < 3; ++k) {
    first_is_point = first_is_point || !divides(f, p[k]);
    second_is_point = second_is_point || !divides(f, q[k]);
  }
  if (!first_is_point || !second_is_point) return false;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t l = 0; l < k; ++l)
      if (!divides(f, p[k] * q[l] - p[l] * q[k])) return false;
  // Two different lines have no other point in common; equal ones have all.
  const std::vector<Polynomial> a = coefficients(first.coordinates()[3], 1, 1, 0);
  const std::vector<Polynomial> c = coefficients(second.coordinates()[3], 0, 1, 1);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t l = 0; l < k; ++l) {
      // Finite points of the lines, times their weights: their difference is parallel to p if the lines are equal.
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
          const auto difference = [&](std::size_t m) {
            return coefficients(first.coordinates()[m], 1, 1, 0)[i] * c[j] -
                   coefficients(second.coordinates()[m], 0, 1, 1)[j] * a[i];
          };
          if (!divides(f, difference(k) * p[l] - difference(l) * p[k])) return true;
        }
    }
  return false;
}

}  // namespace

bool proves_weight_zero(const SeparatedBezoutian& matrix, const RationalSurface& first, const RationalSurface& second,
                        const Polynomial& f, std::uint64_t seed, const Context& context) {
  if (matrix.size() == 1) return lines_meet_at_infinity(first, second, f);
  const KernelOnComponent kernel(matrix, f, seed, context);
  if (!kernel.found()) return false;
  // At the common point both weights vanish or none: where one of the parameters is known, so is the weight.
  const bool in_v = matrix.first_degree() > 1;
  const auto parameter = in_v ? kernel.first_parameter() : kernel.second_parameter();
  if (!parameter) return false;
  const std::vector<Polynomial> weight = in_v ? coefficients(first.coordinates()[3], 1, first.bidegree()[1], 0)
                                              : coefficients(second.coordinates()[3], 0, second.bidegree()[0], 1);
  return divides(f, form_at(weight, *parameter));
}

bool proves_one_point(const SeparatedBezoutian& matrix, const Polynomial& f, std::uint64_t seed,
                      const Context& context) {
  if (f.degree(0) > 0 && f.degree(1) > 0) return false;
  const KernelOnComponent kernel(matrix, f, seed, context);
  if (!kernel.found()) return false;
  // On a line t = t_0 the common point is Psi(s, t_0): it stands still when s does, while u moves.
  const std::size_t moving = f.degree(0) > 0 ? 1 : 0;
  const auto parameter = moving == 0 ? kernel.second_parameter() : kernel.first_parameter();
  if (!parameter) return false;
  const auto& [y, x] = *parameter;
  return divides(f, x.derivative(moving) * y - x * y.derivative(moving));
}

bool divides_weight(const RationalSurface& surface, const Polynomial& f) {
  return divides(f, surface.coordinates()[3]);
}

}  // namespace eliminant::symbolic
