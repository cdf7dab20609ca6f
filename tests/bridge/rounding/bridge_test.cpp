// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/bridge/certificates/krawczyk_test.hpp>
#include <eliminant/bridge/enclosures/decimal.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/bridge/rounding/power_of_two_scaling.hpp>
#include <eliminant/bridge/rounding/round_matrix.hpp>
#include <eliminant/symbolic/matrices/bezout_matrix.hpp>
#include <support/curves.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;
using symbolic::Integer;
using symbolic::UnivariatePolynomial;

namespace {

const Context context;

bool contains(const ComplexBall& ball, long number) {
  return acb_contains_fmpz(ball.get(), Integer(number).get()) != 0;
}

PlaneBall point(double x, double y) { return {ComplexBall(x, 0), ComplexBall(y, 0)}; }

PlaneBall box(double x, double y, double radius) {
  PlaneBall result = point(x, y);
  mag_t r;
  mag_init(r);
  mag_set_d(r, radius);
  for (ComplexBall* coordinate : {&result.x, &result.y}) {
    arb_add_error_mag(coordinate->real(), r);
    arb_add_error_mag(coordinate->imaginary(), r);
  }
  mag_clear(r);
  return result;
}

}  // namespace

TEST_CASE("Rounding: values are the nearest doubles of the entries over a power of two") {
  symbolic::PolynomialMatrix matrix(1, 1);
  UnivariatePolynomial entry;
  fmpz_poly_set_coeff_fmpz(entry.get(), 0, Integer::from_string("9007199254740993").get());  // 2^53 + 1: a tie
  fmpz_poly_set_coeff_fmpz(entry.get(), 1, symbolic::power(Integer(10), 400).get());
  matrix.set_entry(0, 0, entry);
  const auto rounded = round_matrix<double>(matrix);
  CHECK(rounded.scale_log2 == 1329);  // bit length of 10^400
  CHECK(rounded.relative_error_bits == 53);
  CHECK(rounded.value.coefficients[1](0, 0) >= 0.5);
  CHECK(rounded.value.coefficients[1](0, 0) < 1);
  const auto small = [&] {
    symbolic::PolynomialMatrix one(1, 1);
    UnivariatePolynomial constant;
    fmpz_poly_set_coeff_fmpz(constant.get(), 0, Integer::from_string("9007199254740993").get());
    one.set_entry(0, 0, constant);
    return round_matrix<double>(one);
  }();
  CHECK(small.value.coefficients[0](0, 0) == std::ldexp(9007199254740992.0, -static_cast<int>(small.scale_log2)));
}

TEST_CASE_TEMPLATE("Rounding: the stated relative error holds at every precision", Scalar, double, numeric::Real128,
                   numeric::Real256, numeric::Real512, numeric::Real1024) {
  const Polynomial p = curve("1/3*x^2 - 22/7*x*y + 10^30/9");
  const auto rounded = round_polynomial<Scalar>(p);
  CHECK(rounded.relative_error_bits >= std::numeric_limits<Scalar>::digits);
  Scalar third = 1;
  third /= 3;
  using std::ldexp;
  const Scalar expected = ldexp(third, -static_cast<int>(rounded.scale_log2));
  CHECK(rounded.value.coefficients(2, 0) == expected);
}

TEST_CASE("Scaling: balances coefficients that a power of two substitution can balance") {
  const PowerOfTwoScaling scaling = choose_scaling(curve("x^2 + y^2 - 2^200"), curve("x - y"));
  CHECK(scaling.x_log2 > 50);
  CHECK(scaling.y_log2 > 50);
  const PowerOfTwoScaling none = choose_scaling(curve("x^2 + y^2 - 1"), curve("x - y"));
  CHECK(none.x_log2 == 0);
  CHECK(none.y_log2 == 0);
}

TEST_CASE("Krawczyk test: proves a simple zero, and nothing where there is none, two, or a double one") {
  const BallCurve circle(curve("x^2 + y^2 - 5"));
  const BallCurve hyperbola(curve("x*y - 2"));
  const auto image = krawczyk_test(circle, hyperbola, box(1.0001, 1.9999, 1e-3), 64);
  REQUIRE(image.has_value());
  CHECK(contains(image->x, 1));
  CHECK(contains(image->y, 2));
  CHECK_FALSE(krawczyk_test(circle, hyperbola, box(1.2, 1.8, 1e-3), 64).has_value());
  CHECK_FALSE(krawczyk_test(circle, hyperbola, box(1.5, 1.5, 0.6), 64).has_value());
  const BallCurve parabola(curve("y - x^2"));
  const BallCurve axis(curve("y"));
  for (const double radius : {1e-1, 1e-5, 1e-15, 1e-30})
    CHECK_FALSE(krawczyk_test(parabola, axis, box(0, 0, radius), 256).has_value());
  // An uninvertible Jacobian at the midpoint, and a box of width zero around a zero.
  CHECK_FALSE(krawczyk_test(parabola, axis, point(0, 0), 64).has_value());
}

TEST_CASE("Simple zero: enclosed as tightly as asked, from a rough start") {
  const BallCurve circle(curve("x^2 + y^2 - 1"));
  const BallCurve line(curve("x - y"));
  for (const long target : {-50L, -500L, -5000L}) {
    const auto enclosed = enclose_simple_zero(circle, line, point(0.7, 0.71), target, 1L << 16);
    REQUIRE(enclosed.has_value());
    // 2 x^2 = 1.
    ComplexBall square;
    acb_mul(square.get(), enclosed->box.x.get(), enclosed->box.x.get(), 10000);
    acb_mul_2exp_si(square.get(), square.get(), 1);
    CHECK(contains(square, 1));
    CHECK(mag_cmp_2exp_si(arb_radref(enclosed->box.x.real()), target) <= 0);
  }
  CHECK_FALSE(enclose_simple_zero(BallCurve(curve("y - x^2")), BallCurve(curve("y")), point(0.01, 0), -60, 512));
}

TEST_CASE("Reality: a zero near the real plane is told from a real one") {
  // x^2 = -10^-20: two zeros at distance 2 10^-10; x^2 = 10^-20: two real ones.
  const BallCurve line(curve("y"));
  const BallCurve imaginary(curve("x^2 + 10^(-20)"));
  const BallCurve real(curve("x^2 - 10^(-20)"));
  const auto i_zero = enclose_simple_zero(imaginary, line, {ComplexBall(0, 1e-10), ComplexBall()}, -80, 1024);
  REQUIRE(i_zero.has_value());
  CHECK_FALSE(zero_is_real(imaginary, line, i_zero->box));
  const auto r_zero = enclose_simple_zero(real, line, point(1e-10, 0), -80, 1024);
  REQUIRE(r_zero.has_value());
  CHECK(zero_is_real(real, line, r_zero->box));
  CHECK(enclose_same_zero(real, line, r_zero->box, r_zero->box));
}

TEST_CASE("Root enclosure: all roots, isolated, real ones exactly real, zero exact") {
  // t (t^2 - 2)(t^2 + 1)(3 t - 10^20)
  UnivariatePolynomial p(std::vector<Integer>{Integer(0), Integer(1)});
  p = p * UnivariatePolynomial({Integer(-2), Integer(0), Integer(1)}) *
      UnivariatePolynomial({Integer(1), Integer(0), Integer(1)}) *
      UnivariatePolynomial({-symbolic::power(Integer(10), 20), Integer(3)});
  for (const long bits : {30L, 300L, 3000L}) {
    const auto roots = enclose_roots(p, bits, context);
    REQUIRE(roots.size() == 6);
    int real = 0;
    int zero = 0;
    for (const ComplexBall& root : roots) {
      if (arb_is_zero(root.imaginary())) ++real;
      if (acb_is_zero(root.get()))
        ++zero;
      else
        CHECK(acb_rel_accuracy_bits(root.get()) >= bits);
    }
    CHECK(real == 4);
    CHECK(zero == 1);
  }
}

TEST_CASE("Root enclosure: roots of very different sizes and very close ones") {
  const auto monic = [](const Integer& numerator, const Integer& denominator) {
    return UnivariatePolynomial({-numerator, denominator});
  };
  const Integer far = symbolic::power(Integer(10), 3000);
  // Roots 10^3000, 10^-3000, 1, 1 + 10^-3000, 1 + 2 10^-3000, and the two of (10^400 t)^2 + 1.
  UnivariatePolynomial p = monic(far, Integer(1)) * monic(Integer(1), far) * monic(Integer(1), Integer(1)) *
                           monic(far + Integer(1), far) * monic(far + Integer(2), far) *
                           UnivariatePolynomial({Integer(1), Integer(0), symbolic::power(Integer(10), 800)});
  const auto roots = enclose_roots(p, 100, context);
  REQUIRE(roots.size() == 7);
  const std::vector<Rational> real{Rational(Integer(1), far), Rational(1), Rational(far + Integer(1), far),
                                   Rational(far + Integer(2), far), Rational(far)};
  for (const Rational& value : real)
    CHECK(std::count_if(roots.begin(), roots.end(), [&](const ComplexBall& root) {
            return arb_is_zero(root.imaginary()) != 0 && arb_contains_fmpq(root.real(), value.get()) != 0;
          }) == 1);
  CHECK(std::count_if(roots.begin(), roots.end(),
                      [](const ComplexBall& root) { return arb_is_zero(root.imaginary()) == 0; }) == 2);
}

TEST_CASE("Root enclosure: Wilkinson's polynomial, x^n - 1, Mignotte's cluster") {
  UnivariatePolynomial wilkinson({Integer(1)});
  for (long k = 1; k <= 60; ++k) wilkinson = wilkinson * UnivariatePolynomial({Integer(-k), Integer(1)});
  const auto roots = enclose_roots(wilkinson, 64, context);
  REQUIRE(roots.size() == 60);
  for (long k = 0; k < 60; ++k) CHECK(contains(roots[static_cast<std::size_t>(k)], k + 1));

  UnivariatePolynomial unity;
  fmpz_poly_set_coeff_si(unity.get(), 300, 1);
  fmpz_poly_set_coeff_si(unity.get(), 0, -1);
  const auto circle = enclose_roots(unity, 64, context);
  REQUIRE(circle.size() == 300);
  CHECK(std::count_if(circle.begin(), circle.end(),
                      [](const ComplexBall& root) { return arb_is_zero(root.imaginary()) != 0; }) == 2);

  // t^30 - 2 (10^20 t - 1)^2: two real roots about 10^-320 apart.
  const UnivariatePolynomial line({Integer(-1), symbolic::power(Integer(10), 20)});
  UnivariatePolynomial mignotte = UnivariatePolynomial({Integer(-2)}) * line * line;
  fmpz_poly_set_coeff_si(mignotte.get(), 30, 1);
  const auto close = enclose_roots(mignotte, 64, context);
  REQUIRE(close.size() == 30);
  CHECK(std::count_if(close.begin(), close.end(),
                      [](const ComplexBall& root) { return arb_is_zero(root.imaginary()) != 0; }) == 4);
}

TEST_CASE("Decimals: rounding is to nearest, half to even, and printing loses nothing") {
  const auto printed = [](const char* exact, long exponent) {
    RealBall ball;
    arb_set_str(ball.get(), exact, 400);
    return round_to_decimal(ball.get(), exponent).to_string();
  };
  CHECK(printed("0.5", -15) == "0.5");
  CHECK(printed("-0.35355339059327376220", -15) == "-0.353553390593274");
  CHECK(printed("0.125", -2) == "0.12");
  CHECK(printed("0.375", -2) == "0.38");
  CHECK(printed("-0.004", -2) == "0");
  CHECK(printed("1234567", 3) == "1235000");
  CHECK(printed("1e-40", -42) == "1e-40");
  CHECK(printed("-1.25e-40", -42) == "-1.25e-40");
  CHECK(printed("1e30", 20) == "1e30");
  CHECK(Decimal{Integer(-125), -2}.to_rational() == Rational(-5) / Rational(4));
  CHECK(decimal_magnitude(ComplexBall(0.5, 0), 15) == 0);
  CHECK(decimal_magnitude(ComplexBall(1, 0), 15) == 1);
  CHECK(decimal_magnitude(ComplexBall(0, -99), 15) == 2);
  CHECK(decimal_magnitude(ComplexBall(1 - 0x1p-53, 0), 15) == 1);
  CHECK(decimal_magnitude(ComplexBall(1 - 0x1p-53, 0), 25) == 0);
}
