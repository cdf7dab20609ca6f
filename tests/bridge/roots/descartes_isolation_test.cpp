// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstdint>
#include <random>

#include <eliminant/bridge/roots/descartes_isolation.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using symbolic::Integer;
using symbolic::UnivariatePolynomial;

namespace {

const Context context;

UnivariatePolynomial linear(long numerator, long denominator = 1) {
  return UnivariatePolynomial({Integer(-numerator), Integer(denominator)});
}

UnivariatePolynomial squarefree_part(const UnivariatePolynomial& p) {
  const UnivariatePolynomial common = symbolic::gcd(p, p.derivative());
  UnivariatePolynomial result;
  fmpz_poly_div(result.get(), p.primitive_part().get(), common.get());
  return result;
}

/// Checks the real roots against the isolation of all complex ones, which shares no step with theirs, and their
/// refinement; returns their number.
std::size_t check(const UnivariatePolynomial& p) {
  constexpr long bits = 200;
  REQUIRE(descartes_isolation(p, context).has_value());
  IsolatedRoots real = IsolatedRoots::real(p, context);
  std::vector<ComplexBall> expected;
  for (const ComplexBall& root : enclose_roots(p, bits, context))
    if (arb_is_zero(root.imaginary()) != 0) expected.push_back(root);
  REQUIRE(real.balls().size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(arb_overlaps(real.balls()[i].real(), expected[i].real()) != 0);
    if (i > 0) CHECK(arb_lt(real.balls()[i - 1].real(), real.balls()[i].real()) != 0);
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const ComplexBall before = real.balls()[i];
    real.refine(i, bits, context);
    CHECK(acb_overlaps(real.balls()[i].get(), expected[i].get()) != 0);
    CHECK(acb_contains(before.get(), real.balls()[i].get()) != 0);
    if (acb_is_zero(real.balls()[i].get()) == 0) CHECK(acb_rel_accuracy_bits(real.balls()[i].get()) >= bits);
  }
  return expected.size();
}

}  // namespace

TEST_CASE("Descartes isolation: roots at the ends and in the middle of intervals") {
  UnivariatePolynomial p = linear(0);
  for (const long root : {1L, -1L, 2L, -2L, 64L}) p = p * linear(root);
  for (const long denominator : {2L, 4L, 1024L}) p = p * linear(1, denominator) * linear(-3, denominator);
  CHECK(check(p) == 12);
  CHECK(check(linear(1)) == 1);
  CHECK(check(linear(0)) == 1);
  CHECK(check(linear(-7, 3)) == 1);
  CHECK(check(UnivariatePolynomial({Integer(1), Integer(0), Integer(1)})) == 0);
}

TEST_CASE("Descartes isolation: neighbours on both sides of a dyadic root") {
  // 1/2 - 2^-80, 1/2, 1/2 + 2^-80, and 1 beside 1 + 2^-80.
  const Integer scale = symbolic::power(Integer(2), 80);
  const Integer half = symbolic::power(Integer(2), 79);
  UnivariatePolynomial p = linear(1, 2) * linear(1);
  p = p * UnivariatePolynomial({-(half + Integer(1)), scale}) * UnivariatePolynomial({Integer(1) - half, scale}) *
      UnivariatePolynomial({-(scale + Integer(1)), scale});
  CHECK(check(p) == 5);
}

TEST_CASE("Descartes isolation: Wilkinson, Mignotte, sizes far apart") {
  UnivariatePolynomial wilkinson({Integer(1)});
  for (long root = 1; root <= 40; ++root) wilkinson = wilkinson * linear(root);
  CHECK(check(wilkinson) == 40);
  // x^n - 2 (a x - 1)^2: two real roots around 1/a that differ by about a^(-n/2 - 1).
  for (const long a : {3L, 1000L, 1000000L}) {
    UnivariatePolynomial mignotte;
    fmpz_poly_set_coeff_si(mignotte.get(), 17, 1);
    mignotte = mignotte - UnivariatePolynomial({Integer(2)}) * symbolic::power(linear(1, a), 2);
    CHECK(check(mignotte) == 3);
  }
  const Integer far = symbolic::power(Integer(10), 50);
  UnivariatePolynomial spread = linear(3, 7);
  for (const UnivariatePolynomial& factor :
       {UnivariatePolynomial({-far, Integer(1)}), UnivariatePolynomial({Integer(1), far}),
        UnivariatePolynomial({far, Integer(0), Integer(-3)})})
    spread = spread * factor;
  CHECK(check(spread) == 5);
}

TEST_CASE("Descartes isolation: planted rational roots among random factors") {
  std::mt19937_64 random(20261);
  const auto draw = [&](long bound) {
    return static_cast<long>(random() % static_cast<std::uint64_t>(2 * bound + 1)) - bound;
  };
  for (int round = 0; round < 200; ++round) {
    UnivariatePolynomial p({Integer(1)});
    const long planted = 1 + static_cast<long>(random() % 8);
    for (long i = 0; i < planted; ++i) p = p * linear(draw(40), 1 + static_cast<long>(random() % 16));
    std::vector<Integer> coefficients;
    const long degree = static_cast<long>(random() % 30);
    for (long i = 0; i < degree; ++i) coefficients.emplace_back(draw(1000));
    coefficients.emplace_back(1 + static_cast<long>(random() % 1000));
    check(squarefree_part(p * UnivariatePolynomial(coefficients)));
  }
}
