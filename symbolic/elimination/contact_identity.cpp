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

/// The determinant of four rows, by Laplace's expansion by pairs of rows.
Polynomial determinant_of(const Coordinates& a, const Coordinates& b, const Coordinates& c, const Coordinates& d) {
  const auto term = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    return minor(a, b, i, j) * minor(c, d, k, l);
  };
  return term(0, 1, 2, 3) - term(0, 2, 1, 3) + term(0, 3, 1, 2) + term(1, 2, 0, 3) - term(1, 3, 0, 2) +
         term(2, 3, 0, 1);
}

/// The homogeneous coordinates and their derivatives by both parameters.
struct Jet {
  Coordinates point;
  std::array<Coordinates, 2> by;
};

/// At (a, b) given as polynomials.
Jet jet_at(const std::vector<Polynomial>& map, const std::array<Polynomial, 2>& at) {
  const auto composed = [&](const auto& p_of) {
    return Coordinates{p_of(0).compose(at), p_of(1).compose(at), p_of(2).compose(at), p_of(3).compose(at)};
  };
  return {composed([&](std::size_t k) { return map[k]; }),
          {composed([&](std::size_t k) { return map[k].derivative(0); }),
           composed([&](std::size_t k) { return map[k].derivative(1); })}};
}

}  // namespace

bool vanishes_along(const Polynomial& p, const Polynomial& curve) { return divides(curve, p); }

namespace {

/// Maps along the curve of a relation.
class AlongCurve {
 public:
  AlongCurve(const std::vector<Polynomial>& first, const std::vector<Polynomial>& second,
             const ContactRelation& relation)
      : first_(first),
        second_(second),
        relation_(relation),
        substitution_(relation, bidegree_of(second)),
        point_(substituted([&](std::size_t k) { return second[k]; })) {}

  /// Not where a denominator vanishes along the curve.
  bool is_defined() const {
    return std::none_of(relation_.denominator.begin(), relation_.denominator.end(),
                        [&](const Polynomial& denominator) { return divides(relation_.curve, denominator); });
  }

  bool has_equal_points() const {
    for (std::size_t k = 0; k < 3; ++k)
      if (!divides(relation_.curve, first_[k] * point_[3] - first_[3] * point_[k])) return false;
    return true;
  }

  /// Where points are equal: the tangent plane of the second map is spanned by its point and both derivatives.
  bool has_equal_tangent_planes() const {
    const Coordinates by_s = substituted([&](std::size_t k) { return second_[k].derivative(0); });
    const Coordinates by_t = substituted([&](std::size_t k) { return second_[k].derivative(1); });
    for (std::size_t parameter = 0; parameter < 2; ++parameter) {
      Coordinates along{Polynomial(2), Polynomial(2), Polynomial(2), Polynomial(2)};
      for (std::size_t k = 0; k < 4; ++k) along[k] = first_[k].derivative(parameter);
      if (!divides(relation_.curve, determinant_of(along, point_, by_s, by_t))) return false;
    }
    return true;
  }

 private:
  static std::array<unsigned long, 2> bidegree_of(const std::vector<Polynomial>& map) {
    std::array<unsigned long, 2> bidegree{};
    for (const Polynomial& p : map)
      for (std::size_t k = 0; k < 2; ++k)
        bidegree[k] = std::max(bidegree[k], static_cast<unsigned long>(std::max(p.degree(k), 0L)));
    return bidegree;
  }

  template <class Coordinate>
  Coordinates substituted(const Coordinate& p_of) const {
    return {substitution_.in(p_of(0)), substitution_.in(p_of(1)), substitution_.in(p_of(2)), substitution_.in(p_of(3))};
  }

  const std::vector<Polynomial>& first_;
  const std::vector<Polynomial>& second_;
  const ContactRelation& relation_;
  Substitution substitution_;
  Coordinates point_;
};

void require_curve(const ContactRelation& relation) {
  if (relation.curve.is_constant())
    throw InvalidInput("maps were compared along a constant", "the equation of a curve");
}

}  // namespace

bool meet_along(const std::vector<Polynomial>& first, const std::vector<Polynomial>& second,
                const ContactRelation& relation) {
  require_curve(relation);
  const AlongCurve maps(first, second, relation);
  return maps.is_defined() && maps.has_equal_points();
}

bool touch_along(const std::vector<Polynomial>& first, const std::vector<Polynomial>& second,
                 const ContactRelation& relation) {
  require_curve(relation);
  const AlongCurve maps(first, second, relation);
  return maps.is_defined() && maps.has_equal_points() && maps.has_equal_tangent_planes();
}

bool touch_at_roots(const std::vector<Polynomial>& first, const std::vector<Polynomial>& second,
                    const Polynomial& minimal, const std::array<Polynomial, 4>& parameters) {
  if (minimal.is_constant()) throw InvalidInput("maps were compared at roots of a constant", "a polynomial with roots");
  const Jet a = jet_at(first, {parameters[0], parameters[1]});
  const Jet b = jet_at(second, {parameters[2], parameters[3]});
  for (std::size_t k = 0; k < 3; ++k)
    if (!divides(minimal, minor(a.point, b.point, k, 3))) return false;
  return divides(minimal, determinant_of(a.by[0], b.point, b.by[0], b.by[1])) &&
         divides(minimal, determinant_of(a.by[1], b.point, b.by[0], b.by[1]));
}

}  // namespace eliminant::symbolic
