// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <complex>

#include <doctest/doctest.h>

#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>
#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

std::complex<double> to_double(const bridge::ComplexBall& ball) {
  return {arf_get_d(arb_midref(ball.real()), ARF_RND_NEAR), arf_get_d(arb_midref(ball.imaginary()), ARF_RND_NEAR)};
}

/// |p(x, y)| / sum |c_ij x^i y^j| in double precision.
double relative_residual(const Polynomial& p, std::complex<double> x, std::complex<double> y) {
  std::complex<double> sum = 0;
  double magnitude = 0;
  for (const auto& term : p.terms()) {
    const double c = std::stod(term.coefficient.to_string());
    const std::complex<double> value =
        c * std::pow(x, static_cast<double>(term.exponents[0])) * std::pow(y, static_cast<double>(term.exponents[1]));
    sum += value;
    magnitude += std::abs(value);
  }
  return std::abs(sum) / magnitude;
}

}  // namespace

TEST_CASE("Dense random pairs of degree 3 to 12: d^2 distinct solutions, one above each root of the resultant") {
  Random random(41);
  for (unsigned long degree = 3; degree <= 12; ++degree) {
    CAPTURE(degree);
    PlaneCurvesProblem input;
    input.p = random_dense(random, degree, 1000);
    input.q = random_dense(random, degree, 1000);
    Options options;
    options.precision_bits = 53;
    const Result result = solve(input, options);
    CHECK(result.status == Status::certified);
    CHECK(audit_holds(result));
    REQUIRE(result.solutions.size() == degree * degree);
    REQUIRE(result.engine.largest_error_before_refinement.has_value());
    MESSAGE("degree " << degree << ": largest error before refinement "
                      << *result.engine.largest_error_before_refinement << ", engine " << result.engine.method);
    for (const Solution& s : result.solutions) {
      CHECK(s.multiplicity == 1);
      CHECK(relative_residual(input.p, to_double(s.x.ball), to_double(s.y.ball)) < 1e-12);
      CHECK(relative_residual(input.q, to_double(s.x.ball), to_double(s.y.ball)) < 1e-12);
    }
    if (degree > 8) continue;  // isolating the roots of the resultant takes longer than everything else
    const auto resultant =
        symbolic::resultant(symbolic::hide_variable(input.p, 0), symbolic::hide_variable(input.q, 0));
    const Context context;
    const auto roots = bridge::enclose_roots(resultant, 80, context);
    REQUIRE(roots.size() == result.solutions.size());
    for (const auto& root : roots)
      CHECK(std::count_if(result.solutions.begin(), result.solutions.end(),
                          [&](const Solution& s) { return acb_overlaps(s.x.ball.get(), root.get()) != 0; }) == 1);
  }
}

TEST_CASE("Dense random pairs: both engines, both matrices, other seeds give the same bytes") {
  Random random(42);
  for (const unsigned long degree : {2UL, 4UL, 6UL}) {
    PlaneCurvesProblem input;
    input.p = random_dense(random, degree, 100);
    input.q = random_dense(random, degree + 1, 100);
    CAPTURE(text(input.p));
    CAPTURE(text(input.q));
    const std::string expected = printed(solve(input));
    Options options;
    options.engine = Engine::exact;
    CHECK(printed(solve(input, options)) == expected);
    options = {};
    options.matrix = ResultantMatrix::sylvester;
    options.seed = 77;
    CHECK(printed(solve(input, options)) == expected);
    options = {};
    options.engine = Engine::pencil;
    options.precision_bits = 128;
    CHECK(printed(solve(input, options)) == expected);
  }
}
