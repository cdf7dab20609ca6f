// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/bridge/enclosures/interval_polynomial.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>

using eliminant::bridge::DoubleInterval;
using eliminant::bridge::IntervalPolynomial;

TEST_CASE("Interval polynomial: values, derivatives and values in a frame enclose the true ones tightly") {
  const std::vector<std::string> names{"u", "v"};
  const IntervalPolynomial p(eliminant::symbolic::parse_polynomial("u^2*v - 3*u*v + v^2/3 + 2", names));
  const auto exact = [](double u, double v) { return u * u * v - 3 * u * v + v * v / 3 + 2; };
  CHECK(p.near(0.5, 2) == doctest::Approx(exact(0.5, 2)));
  CHECK(p.derivative(0).near(0.5, 2) == doctest::Approx(2 * 0.5 * 2 - 3 * 2));
  CHECK(p.derivative(1).near(0.5, 2) == doctest::Approx(0.25 - 1.5 + 4.0 / 3));
  const IntervalPolynomial framed = p.in_frame({0.25, 0.5}, {0.6, 0.8}, {-0.8, 0.6});
  const DoubleInterval x(-0.125, 0.25);
  const DoubleInterval y(-0.0625, 0.125);
  const DoubleInterval values = framed.on(x, y);
  for (const double a : {x.lower, 0.0, x.upper})
    for (const double b : {y.lower, 0.0, y.upper}) {
      const double value = exact(0.25 + 0.6 * a - 0.8 * b, 0.5 + 0.8 * a + 0.6 * b);
      CHECK(values.lower <= value);
      CHECK(value <= values.upper);
      const DoubleInterval at = framed.on(a, b);
      CHECK(at.lower <= value + 1e-15);
      CHECK(value - 1e-15 <= at.upper);
      CHECK(at.upper - at.lower < 1e-13);
    }
  CHECK(values.upper - values.lower < 2);
}
