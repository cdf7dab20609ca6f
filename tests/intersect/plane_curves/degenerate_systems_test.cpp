// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

/// distinct, real, with multiplicity, at infinity.
std::vector<unsigned long> counts(const Result& result) {
  return {result.counts.distinct, result.counts.real, result.counts.with_multiplicity, result.counts.at_infinity};
}

using Expected = std::vector<unsigned long>;

std::string in_words(const Result& result) {
  std::string words = "found";
  for (const unsigned long count : counts(result)) words += " " + std::to_string(count);
  return words;
}

void check_certified(const char* p, const char* q, const Expected& expected) {
  CAPTURE(p);
  CAPTURE(q);
  const Result result = solve(p, q);
  CHECK(result.status == Status::certified);
  CHECK(audit_holds(result));
  CHECK_MESSAGE(counts(result) == expected, in_words(result));
}

Box box(const char* lower_x, const char* upper_x, const char* lower_y, const char* upper_y) {
  const auto number = [](const char* text) { return curve(text).constant_term(); };
  return {{number(lower_x), number(upper_x)}, {number(lower_y), number(upper_y)}};
}

}  // namespace

TEST_CASE("Common component: reported exactly, the rest solved and certified") {
  const Result result = solve("(x-y)*(x^2+y^2-1)", "(x-y)*(x-2)");
  CHECK(result.status == Status::infinite);
  REQUIRE(result.rest_status.has_value());
  CHECK(*result.rest_status == Status::certified);
  REQUIRE(result.common_component.has_value());
  CHECK(*result.common_component == curve("x-y"));
  CHECK(counts(result) == Expected{2, 0, 2, 0});
  CHECK(printed(result) ==
        "2 0 0 -1.73205080756888 1e-14 x1\n"
        "2 0 0 1.73205080756888 1e-14 x1\n");
}

TEST_CASE("Common component: equal curves, multiples, zero polynomials") {
  const auto component = [](const char* p, const char* q) {
    const Result result = solve(p, q);
    CHECK(result.status == Status::infinite);
    CHECK(result.rest_status == Status::certified);
    CHECK(result.solutions.empty());
    return *result.common_component;
  };
  CHECK(component("x^2+y^2-1", "x^2+y^2-1") == curve("x^2+y^2-1"));
  CHECK(component("-3*(x-y)^2", "(x-y)/7") == curve("x-y"));
  CHECK(component("0", "x*y-1") == curve("x*y-1"));
  CHECK(component("x*y-1", "0") == curve("x*y-1"));
  CHECK(component("0", "0").is_zero());
}

TEST_CASE("Empty systems: constants, parallel lines, all solutions at infinity") {
  check_certified("1", "x+y", {0, 0, 0, 0});
  check_certified("0", "3", {0, 0, 0, 0});
  check_certified("2", "3", {0, 0, 0, 0});
  check_certified("x-1", "x-2", {0, 0, 0, 1});
  check_certified("x^2-1", "x^3+2", {0, 0, 0, 6});
  check_certified("x*y-1", "x*y+1", {0, 0, 0, 4});
  check_certified("y - x^2", "y - x^2 - 1", {0, 0, 0, 4});
}

TEST_CASE("Univariate and linear equations") {
  check_certified("x^2-2", "y^2-3", {4, 4, 4, 0});
  check_certified("x^2+1", "y", {2, 0, 2, 0});
  check_certified("x", "y", {1, 1, 1, 0});
  check_certified("(x-1)^3", "y^2-y", {2, 2, 6, 0});
  check_certified("x^3", "y^4", {1, 1, 12, 0});
  check_certified("x + y - 1", "x - y", {1, 1, 1, 0});
}

TEST_CASE("Contacts and singular points: intersection multiplicities") {
  check_certified("y - x^2", "y", {1, 1, 2, 0});
  check_certified("y^2 - x^3", "y", {1, 1, 3, 0});
  check_certified("y^2 - x^3", "x^2 - y^3", {6, 2, 9, 0});
  check_certified("y - x^8", "y", {1, 1, 8, 0});
  check_certified("x^2 + y^2 - 1", "x - 1", {1, 1, 2, 0});
  check_certified("(x^2+y^2)^2 - x^2 + y^2", "x^2 + y^2 - 1/100", {4, 4, 4, 4});
  check_certified("y^2 - x^2*(x+1)", "2*y", {2, 2, 3, 0});
  check_certified("x^5 - y^7", "x^4 - y^3", {14, 2, 28, 0});
  check_certified("(x^2+y^2-2)^2", "(x*y-1)^2", {2, 2, 16, 0});
}

TEST_CASE("Solutions at infinity: counted with their multiplicity there") {
  check_certified("(x-y)*(x+2*y)-1", "(x-y)*(x+3*y)-1", {2, 2, 2, 2});
  check_certified("x^2+y^2-1", "x^2+y^2-2*x", {2, 2, 2, 2});
  check_certified("x^2*y-1", "x*y^2-1", {3, 1, 3, 6});
}

TEST_CASE("Grids: solutions above one another are all found") {
  check_certified("(x-1)*(x-2)*(x-3)*(x-4)", "(y-1)*(y-2)*(y-3)*(y-4)*(y-5)", {20, 20, 20, 0});
  check_certified("(x-1)*(x-2)*(x+y-7)", "(y-1)*(y-2)*(y-5)", {8, 8, 9, 0});
  // Wilkinson's polynomial in both variables.
  const std::string wilkinson = "(t-1)*(t-2)*(t-3)*(t-4)*(t-5)*(t-6)*(t-7)*(t-8)*(t-9)*(t-10)";
  std::string in_x = wilkinson;
  std::string in_y = wilkinson;
  std::replace(in_x.begin(), in_x.end(), 't', 'x');
  std::replace(in_y.begin(), in_y.end(), 't', 'y');
  check_certified(in_x.c_str(), in_y.c_str(), {100, 100, 100, 0});
  check_certified("x^30", "(y^2-2)^20", {2, 2, 1200, 0});
  check_certified("y^3-2", "(x-1)^2*(x^2+1)", {9, 1, 12, 0});
  // Chebyshev polynomials T_6(x), T_6(y).
  check_certified("32*x^6-48*x^4+18*x^2-1", "32*y^6-48*y^4+18*y^2-1", {36, 36, 36, 0});
}

TEST_CASE("Close solutions: told apart, and printed so that their boxes are disjoint") {
  const Result result = solve("y - x^2", "y - 10^(-60)");
  CHECK(result.status == Status::certified);
  CHECK(counts(result) == Expected{2, 2, 2, 0});
  const Result pair = solve("y - (x-1)^2", "y - 10^(-60)");
  REQUIRE(pair.solutions.size() == 2);
  CHECK(pair.status == Status::certified);
  CHECK(pair.solutions[0].x.real == "0." + std::string(30, '9'));
  CHECK(pair.solutions[1].x.real == "1." + std::string(29, '0') + "1");
  CHECK(pair.solutions[0].radius_exponent < -30);
  // The same with a non-real pair.
  const Result complex_pair = solve("y - (x-1)^2", "y + 10^(-60)");
  CHECK(counts(complex_pair) == Expected{2, 0, 2, 0});
}

TEST_CASE("Huge and tiny coefficients") {
  const Result huge = solve("x - 10^400", "y^2 - 10^(-400)");
  // The two points are 2 10^-200 apart: the radius follows the coordinate 10^400, so it takes 960 digits to part them.
  CHECK(printed(huge) == "1e400 0 -1e-200 0 1e-559 x1\n1e400 0 1e-200 0 1e-559 x1\n");
  const Result scaled = solve("10^300*x^2 + 10^300*y^2 - 10^300", "10^(-300)*x - 10^(-300)*y");
  CHECK(scaled.status == Status::certified);
  CHECK(scaled.solutions.back().x.real == "0.707106781186548");
  // Coefficients of 1000 bits.
  Random random(51);
  PlaneCurvesProblem input;
  std::vector<Polynomial::Term> terms[2];
  for (auto& list : terms)
    for (unsigned long i = 0; i <= 3; ++i)
      for (unsigned long j = 0; i + j <= 3; ++j) {
        symbolic::Integer c(1);
        for (int k = 0; k < 16; ++k)
          c = c * symbolic::power(symbolic::Integer(2), 62) + symbolic::Integer(random.nonzero(1L << 61U));
        list.push_back({Rational(c), {i, j}});
      }
  input.p = Polynomial::from_terms(2, terms[0]);
  input.q = Polynomial::from_terms(2, terms[1]);
  const Result large = solve(input);
  CHECK(large.status == Status::certified);
  CHECK(audit_holds(large));
  CHECK(large.counts.distinct == 9);
}

TEST_CASE("Tiny leading coefficient: no root is thrown away for being far out") {
  // chebfun's lost cubic: the roots of 10^(-20) x^3 + x - 1 are all there.
  const Result result = solve("10^(-20)*x^3 + x - 1", "y - x");
  CHECK(counts(result) == Expected{3, 1, 3, 0});
  CHECK(result.status == Status::certified);
}

TEST_CASE("Box: closed, decided exactly on its border, counts of the whole plane stay") {
  PlaneCurvesProblem input = problem("x^2 + y^2 - 25", "(x-3)*(x+4)*(y-5)");
  // Solutions (3, 4), (3, -4), (-4, 3), (-4, -3), (0, 5) twice.
  input.box = box("-4", "3", "-3", "4");
  const Result result = solve(input);
  CHECK(result.status == Status::certified);
  CHECK(printed(result) ==
        "-4 0 -3 0 1e-14 x1\n"
        "-4 0 3 0 1e-14 x1\n"
        "3 0 4 0 1e-14 x1\n");
  CHECK(result.counts.distinct == 5);
  CHECK(result.counts.with_multiplicity == 6);
  CHECK(result.counts.listed == 3);
  input.box = box("-4 + 1/10^50", "3", "-3", "4 - 1/10^50");
  CHECK(solve(input).solutions.empty());
  input.box = box("0", "0", "5", "5");
  const Result one = solve(input);
  REQUIRE(one.solutions.size() == 1);
  CHECK(one.solutions[0].multiplicity == 2);
  // sqrt(2) against the 40 digit decimals around it.
  PlaneCurvesProblem irrational = problem("x^2 - 2", "y");
  irrational.box = box("1414213562373095048801688724209698078569/10^39", "2", "-1", "1");
  CHECK(solve(irrational).solutions.size() == 1);
  irrational.box = box("1414213562373095048801688724209698078570/10^39", "2", "-1", "1");
  CHECK(solve(irrational).solutions.empty());
}

TEST_CASE("Digits: every printed digit is right at 2, 15, 50 and 500 digits") {
  for (const long digits : {2L, 15L, 50L, 500L}) {
    Options options;
    options.digits = digits;
    const Result result = solve("x^2 - 2", "y - x/3", options);
    REQUIRE(result.solutions.size() == 2);
    // |x - sqrt(2)| <= radius: the square of the bounds encloses 2.
    const Solution& s = result.solutions[1];
    const Rational x = curve(s.x.real).constant_term();
    Rational radius(1);
    for (long k = 0; k > s.radius_exponent; --k) radius = radius / Rational(10);
    CHECK(s.radius_exponent == 1 - digits);
    CHECK((x - radius) * (x - radius) < Rational(2));
    CHECK(Rational(2) < (x + radius) * (x + radius));
  }
}

TEST_CASE("Digits: a coordinate that is zero stays so at any precision and with either matrix") {
  for (const ResultantMatrix matrix : {ResultantMatrix::automatic, ResultantMatrix::sylvester, ResultantMatrix::bezout})
    for (const long digits : {15L, 40L, 200L}) {
      Options options;
      options.matrix = matrix;
      options.digits = digits;
      const Result result = solve("y", "1-x*y^3+x^4", options);
      REQUIRE(result.solutions.size() == 4);
      for (const Solution& s : result.solutions) CHECK(s.y.real == "0");
    }
}

TEST_CASE("Real solutions only: listed apart from the counts") {
  Options options;
  options.field = Field::real;
  const Result result = solve("x^3 - 1", "y - x", options);
  CHECK(result.solutions.size() == 1);
  CHECK(result.counts.distinct == 3);
  CHECK(result.status == Status::certified);
}

TEST_CASE("A box: a real solution just outside it is not in the printed box of one inside") {
  PlaneCurvesProblem outside = problem("x*(x-1e-20)", "y-1-x");
  outside.box = Box{{Rational(-1), Rational(0)}, {Rational(-1), Rational(1)}};
  const Result result = solve(outside);
  REQUIRE(result.solutions.size() == 1);
  CHECK(result.solutions[0].radius_exponent < -20);
}

TEST_CASE("Incomplete pencil engine: says so, keeps the exact counts, certifies nothing") {
  Options options;
  options.engine = Engine::pencil;
  options.matrix = ResultantMatrix::bezout;
  options.precision_bits = 53;
  for (const long digits : {2L, 10L, 15L}) {
    options.digits = digits;
    const Result result = solve("(2+x^2+y)^2-1/10^40", "y", options);
    CHECK(result.counts.distinct == 4);
    CHECK(result.counts.with_multiplicity == 4);
    if (result.status == Status::certified) {
      CHECK(result.solutions.size() == 4);
      continue;
    }
    CHECK(result.status == Status::numeric);
    CHECK(result.counts.undecided == 4 - result.solutions.size());
    for (const Solution& s : result.solutions) CHECK_FALSE(s.certified);
  }
  CHECK(solve("(2+x^2+y)^2-1/10^40", "y").status == Status::certified);
}

TEST_CASE("A line and a curve of high degree: no dense matrix of the size of its square") {
  check_certified("x^150-1", "y-x", {150, 2, 150, 0});
}

TEST_CASE("No certification: nothing says certified") {
  Options options;
  options.certify = false;
  const Result result = solve("x^2 - 2", "y - x", options);
  CHECK(result.status == Status::numeric);
  for (const Solution& s : result.solutions) {
    CHECK_FALSE(s.certified);
    CHECK_FALSE(s.reason.empty());
  }
}

TEST_CASE("Options out of range and wrong rings are refused") {
  Options options;
  options.digits = 0;
  CHECK_THROWS_AS(solve("x", "y", options), InvalidInput);
  options = {};
  options.precision_bits = 64;
  CHECK_THROWS_AS(solve("x", "y", options), InvalidInput);
  options = {};
  options.epsilon = -1;
  CHECK_THROWS_AS(solve("x", "y", options), InvalidInput);
  PlaneCurvesProblem wrong = problem("x", "y");
  wrong.p = Polynomial(3);
  CHECK_THROWS_AS(solve(wrong), InvalidInput);
  PlaneCurvesProblem empty_box = problem("x", "y");
  empty_box.box = box("1", "0", "0", "1");
  CHECK_THROWS_AS(solve(empty_box), InvalidInput);
}

TEST_CASE("Limits: a cancelled context and a time limit end the computation with LimitReached") {
  Context cancelled;
  cancelled.cancel();
  CHECK_THROWS_AS(intersect_plane_curves(problem("x^2-y", "y^2-x"), {}, cancelled), LimitReached);
  Context late;
  late.limit_seconds(0);
  CHECK_THROWS_AS(intersect_plane_curves(problem("x^2-y", "y^2-x"), {}, late), LimitReached);
}
