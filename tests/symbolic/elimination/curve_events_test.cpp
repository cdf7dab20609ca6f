// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/symbolic/elimination/curve_events.hpp>
#include <support/curves.hpp>

using namespace eliminant;
using symbolic::Integer;
using symbolic::Rational;
using symbolic::ReducedCurve;
using symbolic::UnivariatePolynomial;
using test::curve;

namespace {

UnivariatePolynomial polynomial(std::vector<long> coefficients) {
  std::vector<Integer> ascending;
  for (const long c : coefficients) ascending.emplace_back(c);
  return UnivariatePolynomial(ascending);
}

}  // namespace

TEST_CASE("Curve events: vertical lines and repeated factors are split off") {
  const ReducedCurve reduced = symbolic::reduced_curve(curve("x^2*(x^2 - 2)*(y - x)^3*(x*y - 1)"));
  CHECK(reduced.vertical_lines == polynomial({0, -2, 0, 1}));
  CHECK((reduced.rest == curve("(y - x)*(x*y - 1)") || reduced.rest == curve("(x - y)*(x*y - 1)")));
  CHECK(reduced.repeated_factor);
  const ReducedCurve lines = symbolic::reduced_curve(curve("3*x - 1"));
  CHECK(lines.vertical_lines == polynomial({-1, 3}));
  CHECK(lines.rest.is_constant());
  CHECK(!lines.repeated_factor);
  const ReducedCurve horizontal = symbolic::reduced_curve(curve("y^2 - 2"));
  CHECK(horizontal.vertical_lines.degree() == 0);
  CHECK(horizontal.rest == curve("y^2 - 2"));
  CHECK(!horizontal.repeated_factor);
}

TEST_CASE("Curve events: restrictions to lines are exact") {
  const auto g = symbolic::hide_variable(curve("x*y^2 - y/3 + x^2"), 0);
  // At x = 1/2: y^2/2 - y/3 + 1/4, times 12.
  CHECK(symbolic::on_vertical_line(g, Rational(1) / Rational(2)) == polynomial({3, -4, 6}));
  CHECK(symbolic::on_vertical_line(g, Rational(0)).degree() == 1);
  CHECK(symbolic::on_horizontal_line(curve("(y - 1)*(x + y)"), Rational(1)).is_zero());
  CHECK(symbolic::on_horizontal_line(curve("x^2 - y"), Rational(2)) == polynomial({-2, 0, 1}));
  CHECK(symbolic::sign_at(polynomial({-2, 0, 1}), Rational(3) / Rational(2)) == 1);
  CHECK(symbolic::sign_at(polynomial({-2, 0, 1}), Rational(7) / Rational(5)) == -1);
  CHECK(symbolic::sign_at(polynomial({-1, 2}), Rational(1) / Rational(2)) == 0);
}

TEST_CASE("Curve events: discriminant, leading coefficient, vertical lines and others are roots once") {
  const Context context;
  const auto events = [&](std::string_view p, const std::vector<UnivariatePolynomial>& others = {}) {
    return symbolic::event_polynomial(symbolic::reduced_curve(curve(p)), others, 0, context);
  };
  CHECK(events("y^2 - x^3 - x^2") == polynomial({0, 1, 1}));
  CHECK(events("x^2 + y^2 - 1", {polynomial({-1, 1}), UnivariatePolynomial()}) == polynomial({-1, 0, 1}));
  CHECK(events("(x - 2)*(x*y - 1)") == polynomial({0, -2, 1}));
  CHECK(events("y - x^2").degree() == 0);
}
