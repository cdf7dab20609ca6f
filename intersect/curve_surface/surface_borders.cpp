// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/surface_borders.hpp>

#include <algorithm>

#include <eliminant/symbolic/geometry/border_curve.hpp>
#include <eliminant/symbolic/matrices/moving_lines.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::MatrixRepresentation;
using symbolic::ParameterForm;
using symbolic::Rational;
using symbolic::RationalCurve;
using symbolic::UnivariatePolynomial;

bool satisfies(const PointOnCurve& point, const ParameterForm& condition) {
  if (condition.finite.is_zero()) return true;
  if (point.exact_t) {
    Rational at;
    fmpz_poly_evaluate_fmpq(at.get(), condition.finite.get(), point.exact_t->get());
    return at.is_zero();
  }
  return point.roots == nullptr ? condition.order_at_infinity > 0
                                : point.roots->is_zero_of(point.index, condition.finite);
}

}  // namespace

const ParameterForm& SurfaceBorders::condition(std::size_t group, const std::optional<Rational>& value) {
  const auto key = std::pair(group, value ? value->to_string() : "inf");
  auto found = conditions_.find(key);
  if (found == conditions_.end())
    found = conditions_.emplace(key, meeting_condition(symbolic::border_curve(surface_, group, value))).first;
  return found->second;
}

ParameterForm SurfaceBorders::meeting_condition(const std::optional<RationalCurve>& border) const {
  if (!border) return {};  // a line of base points: every parameter may belong to it
  if (border->degree() == 0) {
    // A point: the minors of order two of both columns.
    ParameterForm condition;
    const std::vector<symbolic::Integer> point = border->at_infinity();
    long order = curve_.degree();
    const auto& f = curve_.coordinates();
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const UnivariatePolynomial minor =
            f[i] * UnivariatePolynomial({point[j]}) - f[j] * UnivariatePolynomial({point[i]});
        if (minor.is_zero()) continue;
        condition.finite = symbolic::gcd(condition.finite, minor);
        order = std::min(order, curve_.degree() - minor.degree());
      }
    condition.order_at_infinity = order;
    return condition;
  }
  const MatrixRepresentation m =
      symbolic::moving_line_matrix(*border, border->degree() - 1 > 0 ? border->degree() - 1 : 1);
  return symbolic::minors_on_curve(m, curve_, seed_, context_);
}

bool SurfaceBorders::contains(const PointOnCurve& point, std::size_t group, const std::optional<Rational>& value) {
  return satisfies(point, condition(group, value));
}

bool SurfaceBorders::at_line_at_infinity(const PointOnCurve& point, const symbolic::RationalSurface& over_the_plane) {
  constexpr std::size_t last_parameter = 2;
  if (!line_at_infinity_)
    line_at_infinity_ = meeting_condition(symbolic::border_curve(over_the_plane, last_parameter, Rational(0)));
  return satisfies(point, *line_at_infinity_);
}

}  // namespace eliminant::intersect
