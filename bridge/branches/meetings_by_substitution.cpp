// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/meetings_by_substitution.hpp>

#include <cstddef>
#include <utility>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Integer;
using symbolic::RationalCurve;
using symbolic::UnivariatePolynomial;

using Meetings = std::vector<std::array<double, 2>>;

UnivariatePolynomial constant(const Integer& value) { return UnivariatePolynomial({value}); }

/// numerator(t) / denominator.
struct Substitute {
  UnivariatePolynomial numerator;
  Integer denominator;
};

/// d^n p(numerator / d) with n the degree of p.
UnivariatePolynomial composed(const UnivariatePolynomial& p, const Substitute& u) {
  UnivariatePolynomial result;
  Integer scale(1);
  for (long i = p.degree(); i >= 0; --i) {
    result = result * u.numerator + constant(p.coefficient(i) * scale);
    scale = scale * u.denominator;
  }
  return result;
}

bool is_polynomial(const RationalCurve& curve) { return curve.coordinates().back().degree() == 0; }

/// The parameter of `other` as a polynomial in that of `curve`.
std::optional<Substitute> substitute(const RationalCurve& curve, const RationalCurve& other) {
  const Integer weight = curve.coordinates().back().coefficient(0);
  const Integer other_weight = other.coordinates().back().coefficient(0);
  for (std::size_t k = 0; k < curve.dimension(); ++k) {
    const UnivariatePolynomial& x = other.coordinates()[k];
    if (x.degree() != 1) continue;
    // x0 + x1 u = other_weight / weight curve_k(t)
    return Substitute{constant(other_weight) * curve.coordinates()[k] - constant(weight * x.coefficient(0)),
                      weight * x.coefficient(1)};
  }
  return std::nullopt;
}

/// The polynomial of the parameters t of common points.
UnivariatePolynomial condition(const RationalCurve& curve, const RationalCurve& other, const Substitute& u) {
  const UnivariatePolynomial& weight = curve.coordinates().back();
  const UnivariatePolynomial& other_weight = other.coordinates().back();
  UnivariatePolynomial result;
  for (std::size_t k = 0; k < curve.dimension(); ++k) {
    const UnivariatePolynomial& x = other.coordinates()[k];
    UnivariatePolynomial own = curve.coordinates()[k] * other_weight;
    for (long i = 0; i < x.degree(); ++i) own = own * constant(u.denominator);
    const UnivariatePolynomial difference = own - weight * composed(x, u);
    result = result.is_zero() ? difference.primitive_part() : gcd(result, difference);
  }
  return result;
}

UnivariatePolynomial squarefree_part(const UnivariatePolynomial& p) {
  const UnivariatePolynomial repeated = gcd(p, p.derivative());
  if (repeated.degree() <= 0) return p;
  UnivariatePolynomial quotient;
  fmpz_poly_div(quotient.get(), p.get(), repeated.get());
  return quotient;
}

class Search {
 public:
  Search(const Substitute& u, const Context& context) : u_(u), context_(context) {}

  std::optional<Meetings> run(UnivariatePolynomial p) {
    for (const long end : {0L, 1L}) take_end(p, end);
    if (p.degree() > 0 && !take_roots(p)) return std::nullopt;
    return std::move(found_);
  }

 private:
  /// A root at an end of the domain of t is divided out.
  void take_end(UnivariatePolynomial& p, long end) {
    Integer value;
    const Integer at(end);
    fmpz_poly_evaluate_fmpz(value.get(), p.get(), at.get());
    if (fmpz_is_zero(value.get()) == 0) return;
    const UnivariatePolynomial factor = UnivariatePolynomial({Integer(-end), Integer(1)});
    UnivariatePolynomial quotient;
    fmpz_poly_div(quotient.get(), p.get(), factor.get());
    p = quotient;
    RealBall t;
    arb_set_si(t.get(), end);
    Integer numerator;
    fmpz_poly_evaluate_fmpz(numerator.get(), u_.numerator.get(), at.get());
    const int sign = fmpz_sgn(u_.denominator.get());
    const bool inside =
        fmpz_sgn(numerator.get()) * sign >= 0 && fmpz_cmpabs(numerator.get(), u_.denominator.get()) <= 0;
    if (inside) add(t);
  }

  bool take_roots(const UnivariatePolynomial& p) {
    IsolatedRoots roots = IsolatedRoots::real(p, context_);
    for (std::size_t i = 0; i < roots.balls().size(); ++i) {
      if (arb_is_zero(roots.balls()[i].imaginary()) == 0) continue;
      roots.refine(i, bits, context_);
      RealBall t;
      arb_set(t.get(), roots.balls()[i].real());
      const std::optional<bool> t_inside = within_unit(t);
      if (!t_inside) return false;
      if (!*t_inside) continue;
      const std::optional<bool> u_inside = within_unit(u_at(t));
      if (!u_inside) return false;
      if (*u_inside) add(t);
    }
    return true;
  }

  RealBall u_at(const RealBall& t) const {
    RealBall u;
    arb_fmpz_poly_evaluate_arb(u.get(), u_.numerator.get(), t.get(), 2 * bits);
    arb_div_fmpz(u.get(), u.get(), u_.denominator.get(), 2 * bits);
    return u;
  }

  /// nullopt where a ball that is no number meets an end.
  static std::optional<bool> within_unit(const RealBall& x) {
    if (arb_is_negative(x.get()) != 0) return false;
    RealBall rest;
    arb_sub_ui(rest.get(), x.get(), 1, 2 * bits);
    if (arb_is_positive(rest.get()) != 0) return false;
    if (arb_is_exact(x.get()) != 0) return true;
    if (arb_is_positive(x.get()) != 0 && arb_is_negative(rest.get()) != 0) return true;
    return std::nullopt;
  }

  void add(const RealBall& t) {
    const auto nearest = [](const RealBall& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); };
    found_.push_back({nearest(t), nearest(u_at(t))});
  }

  static constexpr long bits = 64;
  const Substitute& u_;
  const Context& context_;
  Meetings found_;
};

std::optional<Meetings> meetings_with(const RationalCurve& curve, const RationalCurve& other, const Substitute& u,
                                      const Context& context) {
  const UnivariatePolynomial p = condition(curve, other, u);
  if (p.is_zero()) return std::nullopt;
  return Search(u, context).run(squarefree_part(p));
}

}  // namespace

std::optional<Meetings> meetings_by_substitution(const RationalCurve& first, const RationalCurve& second,
                                                 const Context& context) {
  if (!is_polynomial(first) || !is_polynomial(second)) return std::nullopt;
  if (const std::optional<Substitute> u = substitute(first, second)) return meetings_with(first, second, *u, context);
  const std::optional<Substitute> t = substitute(second, first);
  if (!t) return std::nullopt;
  std::optional<Meetings> found = meetings_with(second, first, *t, context);
  if (found)
    for (std::array<double, 2>& pair : *found) std::swap(pair[0], pair[1]);
  return found;
}

}  // namespace eliminant::bridge
