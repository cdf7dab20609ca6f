// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/contracted_lines.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/intersect/curve_surface/prepared_surface.hpp>
#include <eliminant/intersect/whole_surfaces/projection_charts.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/implicit_equation.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::UnivariatePolynomial;
using Point = std::array<DoubleInterval, 4>;

/// Zero where all points have weight zero for the value of the first parameter.
UnivariatePolynomial infinity_condition(const symbolic::RationalSurface& surface) {
  UnivariatePolynomial result;
  for (const auto& coefficient : symbolic::hide_variable(surface.coordinates()[3], 0).coefficients)
    result = gcd(result, coefficient);
  return result;
}

/// Zero where the surface is one point for the value of its first parameter: the gcd of the minors of order two of its
/// coefficients in the second one.
UnivariatePolynomial contraction_condition(const symbolic::RationalSurface& surface) {
  const auto n = static_cast<std::size_t>(surface.bidegree()[1]);
  std::array<std::vector<UnivariatePolynomial>, 4> coefficients;
  for (std::size_t c = 0; c < 4; ++c) {
    coefficients[c] = symbolic::hide_variable(surface.coordinates()[c], 0).coefficients;
    coefficients[c].resize(n + 1);
  }
  UnivariatePolynomial result;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t k = 0; k < j; ++k)
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < a; ++b)
          result = gcd(result, coefficients[a][j] * coefficients[b][k] - coefficients[a][k] * coefficients[b][j]);
  return result;
}

/// Whether the surface does not pass through the point.
bool avoids(const SurfaceCharts& surface, const Point& point) {
  struct Box {
    std::array<bool, 2> inverted;
    std::array<DoubleInterval, 2> at;
  };
  std::vector<Box> open;
  for (const bool first : {false, true})
    for (const bool second : {false, true})
      open.push_back({{first, second}, {DoubleInterval(-1, 1), DoubleInterval(-1, 1)}});
  for (int visited = 0; !open.empty(); ++visited) {
    if (visited > 20000) return false;
    const Box box = open.back();
    open.pop_back();
    const Point value = surface.value(box.inverted, box.at);
    bool excluded = false;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < i; ++k)
        excluded = excluded || (value[i] * point[k] - value[k] * point[i]).excludes_zero();
    if (excluded) continue;
    const std::size_t widest = width(box.at[0]) >= width(box.at[1]) ? 0 : 1;
    if (width(box.at[widest]) < 1e-6) return false;
    for (const bool upper : {false, true}) {
      Box half = box;
      (upper ? half.at[widest].lower : half.at[widest].upper) = middle(box.at[widest]);
      open.push_back(half);
    }
  }
  return true;
}

/// The same by the implicit equation, which base points do not disturb, for surfaces of low degree.
bool equation_excludes(const symbolic::RationalSurface& surface, const Point& point, const Context& context) {
  constexpr long largest_degree = 8;
  const symbolic::SurfacePiece piece{surface, std::nullopt};
  PreparedSurface prepared(piece, 0, context);
  if (prepared.degree().product > largest_degree) return false;
  try {
    const symbolic::Polynomial equation =
        symbolic::implicit_equation(prepared.map(), prepared.matrix(), prepared.degree(), 0, context);
    DoubleInterval sum;
    for (const auto& term : equation.terms()) {
      DoubleInterval product = enclose(term.coefficient);
      for (std::size_t c = 0; c < 4; ++c)
        for (unsigned long e = 0; e < term.exponents[c]; ++e) product = product * point[c];
      sum = sum + product;
    }
    return sum.excludes_zero();
  } catch (const InvalidInput&) {
    return false;
  }
}

bool avoids_contracted_point(const SurfaceCharts& surface, bool inverted, const DoubleInterval& value,
                             const symbolic::RationalSurface& other, const Context& context) {
  // Another value of the second parameter where this one gives a base point.
  for (const double second : {0.25, 0.5, -0.75}) {
    const Point point = surface.value({inverted, false}, {value, DoubleInterval(second)});
    if (std::any_of(point.begin(), point.end(), [](const auto& x) { return x.excludes_zero(); }))
      return avoids(SurfaceCharts(other), point) || equation_excludes(other, point, context);
  }
  return false;
}

}  // namespace

bool contracts_nothing_to(const symbolic::RationalSurface& surface, const symbolic::RationalSurface& other,
                          const Context& context) {
  for (const bool exchanged : {false, true}) {
    const symbolic::RationalSurface turned = exchanged ? exchange_parameters(surface) : surface;
    const SurfaceCharts charts(turned);
    const UnivariatePolynomial condition = contraction_condition(turned);
    if (condition.is_zero()) return false;
    // The same with the inverse of the parameter, at 0.
    const symbolic::RationalSurface reversed = change_parameters(turned, {chart(true), ProjectiveChange()});
    const UnivariatePolynomial at_infinity = contraction_condition(reversed);
    const bool is_affine = !(infinity_condition(reversed).coefficient(0) == symbolic::Integer(0));
    if (is_affine && at_infinity.coefficient(0) == symbolic::Integer(0) &&
        !avoids_contracted_point(charts, true, DoubleInterval(0), other, context))
      return false;
    if (condition.degree() < 1) continue;
    for (const auto& part : symbolic::squarefree_decomposition(condition)) {
      // Points at infinity are no contacts.
      const UnivariatePolynomial infinite = gcd(part.factor, infinity_condition(turned));
      UnivariatePolynomial affine;
      fmpz_poly_div(affine.get(), part.factor.get(), infinite.get());
      if (affine.degree() < 1) continue;
      bridge::IsolatedRoots roots = bridge::IsolatedRoots::real(affine, context);
      for (std::size_t k = 0; k < roots.balls().size(); ++k) {
        roots.refine(k, 60, context);
        const bridge::ComplexBall& root = roots.balls()[k];
        const double centre = arf_get_d(arb_midref(root.real()), ARF_RND_NEAR);
        const double radius = 1e-14 * std::fabs(centre) + mag_get_d(arb_radref(root.real()));
        const DoubleInterval value = DoubleInterval::around(centre, radius);
        const bool inverted = std::fabs(centre) > 1;
        if (!avoids_contracted_point(charts, inverted, inverted ? eliminant::intersect::inverse(value) : value, other,
                                     context))
          return false;
      }
    }
  }
  return true;
}

}  // namespace eliminant::intersect
