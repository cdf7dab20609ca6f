// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/contact_identity.hpp>

#include <algorithm>
#include <cstddef>

#include <eliminant/base/error.hpp>

namespace eliminant::symbolic {

namespace {

using Coordinates = std::array<Polynomial, 4>;

bool divides(const Polynomial& divisor, const Polynomial& p) {
  Polynomial quotient(2);
  return fmpq_mpoly_divides(quotient.get(), p.get(), divisor.get(), p.ring()) != 0;
}

/// 1, p, p^2, ...
std::vector<Polynomial> powers(const Polynomial& p, unsigned long highest) {
  std::vector<Polynomial> result{Polynomial::constant(2, 1)};
  for (unsigned long k = 1; k <= highest; ++k) result.push_back(result.back() * p);
  return result;
}

/// A polynomial of at most this bidegree at the parameters of the relation, times the denominators to that bidegree.
class Substitution {
 public:
  Substitution(const ContactRelation& relation, const std::array<unsigned long, 2>& bidegree) : bidegree_(bidegree) {
    for (std::size_t k = 0; k < 2; ++k) {
      numerators_[k] = powers(relation.numerator[k], bidegree[k]);
      denominators_[k] = powers(relation.denominator[k], bidegree[k]);
    }
  }

  Polynomial in(const Polynomial& p) const {
    Polynomial sum(2);
    for (const Polynomial::Term& term : p.terms()) {
      Polynomial product = Polynomial::constant(2, term.coefficient);
      for (std::size_t k = 0; k < 2; ++k) {
        const unsigned long e = term.exponents[k];
        product = product * numerators_[k][e] * denominators_[k][bidegree_[k] - e];
      }
      sum = sum + product;
    }
    return sum;
  }

 private:
  std::array<unsigned long, 2> bidegree_;
  std::array<std::vector<Polynomial>, 2> numerators_;
  std::array<std::vector<Polynomial>, 2> denominators_;
};

/// Of two rows, the minor of the columns i and j.
Polynomial minor(const Coordinates& a, const Coordinates& b, std::size_t i, std::size_t j) {
  return a[i] * b[j] - a[j] * b[i];
}

}  // namespace

bool vanishes_along(const Polynomial& p, const Polynomial& curve) { return divides(curve, p); }

bool touch_along(const std::vector<Polynomial>& first, const std::vector<Polynomial>& second,
                 const ContactRelation& relation) {
  if (relation.curve.is_constant())
    throw InvalidInput("maps were compared along a constant", "the equation of a curve");
  for (const Polynomial& denominator : relation.denominator)
    if (divides(relation.curve, denominator)) return false;
  std::array<unsigned long, 2> bidegree{};
  for (const Polynomial& p : second)
    for (std::size_t k = 0; k < 2; ++k)
      bidegree[k] = std::max(bidegree[k], static_cast<unsigned long>(std::max(p.degree(k), 0L)));
  const Substitution substitution(relation, bidegree);
  const auto substituted = [&](const auto& p_of) {
    return Coordinates{substitution.in(p_of(0)), substitution.in(p_of(1)), substitution.in(p_of(2)),
                       substitution.in(p_of(3))};
  };
  const Coordinates point = substituted([&](std::size_t k) { return second[k]; });
  for (std::size_t k = 0; k < 3; ++k)
    if (!divides(relation.curve, first[k] * point[3] - first[3] * point[k])) return false;
  // The tangent plane of the second is spanned by its point and both derivatives.
  const Coordinates by_s = substituted([&](std::size_t k) { return second[k].derivative(0); });
  const Coordinates by_t = substituted([&](std::size_t k) { return second[k].derivative(1); });
  for (std::size_t parameter = 0; parameter < 2; ++parameter) {
    Coordinates along{Polynomial(2), Polynomial(2), Polynomial(2), Polynomial(2)};
    for (std::size_t k = 0; k < 4; ++k) along[k] = first[k].derivative(parameter);
    // Laplace's expansion by pairs of rows.
    const auto term = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      return minor(along, point, i, j) * minor(by_s, by_t, k, l);
    };
    const Polynomial determinant =
        term(0, 1, 2, 3) - term(0, 2, 1, 3) + term(0, 3, 1, 2) + term(1, 2, 0, 3) - term(1, 3, 0, 2) + term(2, 3, 0, 1);
    if (!divides(relation.curve, determinant)) return false;
  }
  return true;
}

}  // namespace eliminant::symbolic
