// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/common_border.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/bridge/contacts/contact_curve_points.hpp>
#include <eliminant/bridge/contacts/contact_relation_fit.hpp>
#include <eliminant/bridge/nets/exact_map.hpp>
#include <eliminant/symbolic/elimination/contact_identity.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::ContactRelation;
using symbolic::Polynomial;
using symbolic::Rational;

/// A border of the patch whose parameters are 2 k and 2 k + 1 of u, v, s, t.
struct Border {
  std::size_t axis = 0;
  int side = -1;

  std::size_t patch() const { return axis / 2; }
  Polynomial bound() const { return Polynomial::constant(2, side < 0 ? 0 : 1); }
};

/// The border of the other patch on which all points are, as far as doubles can tell.
std::optional<Border> border_of_other(const std::vector<std::array<double, 4>>& points, std::size_t patch) {
  constexpr double accuracy = 1e-9;
  for (const std::size_t axis : {2 - 2 * patch, 3 - 2 * patch})
    for (const int side : {-1, 1})
      if (std::all_of(points.begin(), points.end(), [&](const std::array<double, 4>& at) {
            return std::fabs(at[axis] - (side < 0 ? 0 : 1)) < accuracy;
          }))
        return Border{axis, side};
  return std::nullopt;
}

/// Bernstein coefficients on [0, 1] of a polynomial in the parameters of a patch along one of its borders.
std::vector<Rational> coefficients_along(const Polynomial& p, const Border& border) {
  std::array<Polynomial, 2> at{Polynomial::variable(2, 0), Polynomial::variable(2, 0)};
  at[border.axis % 2] = border.bound();
  const Polynomial restricted = p.compose(at);
  std::vector<Rational> powers(static_cast<std::size_t>(std::max(restricted.degree(0), 0L)) + 1);
  for (const Polynomial::Term& term : restricted.terms()) powers[term.exponents[0]] = term.coefficient;
  return symbolic::bernstein_coefficients(powers, {0, 1});
}

/// The parameter along the one border as a quotient in that along the other.
struct Parameter {
  Polynomial numerator{2};
  Polynomial denominator{2};
  Border border;

  /// It runs within [0, 1].
  bool stays_inside() const {
    return has_no_pole() && is_not_negative(numerator * sign()) && is_not_negative((denominator - numerator) * sign());
  }
  /// It reaches all of [0, 1], being continuous.
  bool reaches_both_ends() const {
    if (!has_no_pole()) return false;
    const std::vector<Rational> above = coefficients_along(numerator, border);
    const std::vector<Rational> rest = coefficients_along(denominator - numerator, border);
    return (above.front().is_zero() && rest.back().is_zero()) || (rest.front().is_zero() && above.back().is_zero());
  }

 private:
  bool has_no_pole() const {
    const std::vector<Rational> below = coefficients_along(denominator, border);
    return std::all_of(below.begin(), below.end(),
                       [&](const Rational& x) { return x.sign() != 0 && x.sign() == below.front().sign(); });
  }
  Polynomial sign() const { return Polynomial::constant(2, coefficients_along(denominator, border).front().sign()); }
  bool is_not_negative(const Polynomial& p) const {
    const std::vector<Rational> all = coefficients_along(p, border);
    return std::all_of(all.begin(), all.end(), [](const Rational& x) { return x.sign() >= 0; });
  }
};

/// The parameter along `to` where points of `from` are on it; proven where there is one.
std::optional<Parameter> parameter_on(const Border& to, const Border& from, std::vector<std::array<double, 4>> points,
                                      const PatchPairNets& nets) {
  if (from.patch() == 1)
    for (std::array<double, 4>& p : points) p = {p[2], p[3], p[0], p[1]};
  const auto relation = contact_relation_fit(points);
  const auto line = Polynomial::variable(2, from.axis % 2) - from.bound();
  if (!relation || !symbolic::vanishes_along(line, relation->curve)) return std::nullopt;
  const std::size_t kept = to.axis % 2;
  const Polynomial apart = relation->numerator[kept] - to.bound() * relation->denominator[kept];
  if (!symbolic::vanishes_along(apart, relation->curve)) return std::nullopt;
  const auto first = coordinates_of(from.patch() == 0 ? nets.exact_first : nets.exact_second);
  const auto second = coordinates_of(from.patch() == 0 ? nets.exact_second : nets.exact_first);
  if (!symbolic::meet_along(first, second, *relation)) return std::nullopt;
  return Parameter{relation->numerator[1 - kept], relation->denominator[1 - kept], from};
}

}  // namespace

bool is_common_border(const PatchPairNets& nets, std::size_t axis, int side) {
  const Border own{axis, side};
  const auto points = points_along_border(nets.first, nets.second, {axis, side, 0, 1});
  if (points.empty()) return false;
  const auto other = border_of_other(points, own.patch());
  if (!other) return false;
  // As a function of the parameter of the own border it has to stay inside; the other way round it has to reach all.
  if (const auto parameter = parameter_on(*other, own, points, nets)) return parameter->stays_inside();
  const auto parameter = parameter_on(own, *other, points, nets);
  return parameter && parameter->reaches_both_ends();
}

}  // namespace eliminant::bridge
