// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <functional>

#include <eliminant/intersect/plane_curves/certificate_check.hpp>
#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::Rational;

namespace {

struct System {
  const char* p;
  const char* q;
  /// Shears that the proof needs.
  std::size_t shears;
};

/// Without multiple solutions; with them; at infinity; empty; with a common component; many on one line; close ones.
const std::vector<System> systems{{"x^2+y^2-5", "x*y-2", 0},
                                  {"x^3+y^3-1", "x^3-2*y^2+x", 0},
                                  {"(x-y)*(x+2*y)-1", "(x-y)*(x+3*y)-1", 1},
                                  {"x*y-1", "x", 1},
                                  {"x^2*y-1", "x*y^2-x-1", 1},
                                  {"(x-1)^2+y^2-1", "x", 2},
                                  {"y^5-(x-1)^3*(x+y)^2", "x^4-y^2*(x-1)", 2},
                                  {"y^2-x^3", "y^3-x^5", 2},
                                  {"(x-1)*(x-2)*(y^2+1)", "(y-3)^2*(x+y)", 2},
                                  {"(x^2+1)^2", "y^2-x", 2},
                                  {"y-(x-1)^2", "y-10^(-24)", 0},
                                  {"(y-x^2)^2-10^(-20)*x^3", "y-x^2", 2},
                                  {"10^20*x^2-y", "y-10^(-20)", 0},
                                  {"(x-y)*(x^2+y^2-1)", "(x-y)*(x-2)", 0},
                                  {"(x-y)*(x^2+y^2-1)", "(x-y)*(x-1)", 2}};

Certificate certificate_of(const PlaneCurvesProblem& input) {
  Options options;
  options.certificate = true;
  const Result result = solve(input, options);
  REQUIRE(result.certificate.has_value());
  return *result.certificate;
}

std::vector<std::string> check(const PlaneCurvesProblem& input, const Certificate& certificate) {
  return check_certificate(input, certificate, Context());
}

Rational power_of_ten(long exponent) {
  const Rational power(symbolic::power(symbolic::Integer(10), static_cast<unsigned long>(std::labs(exponent))));
  return exponent < 0 ? Rational(1) / power : power;
}

}  // namespace

TEST_CASE("Certificate: written with as many shears as its proof needs, and accepted") {
  for (const System& system : systems) {
    CAPTURE(std::string(system.p));
    CAPTURE(std::string(system.q));
    const PlaneCurvesProblem input = problem(system.p, system.q);
    const Certificate certificate = certificate_of(input);
    CHECK(certificate.shears.size() == system.shears);
    CHECK(check(input, certificate).empty());
  }
}

TEST_CASE("Certificate: every corruption is refused") {
  using Change = std::function<bool(Certificate&, std::size_t)>;  // false: does not apply to this ball
  const std::vector<std::pair<const char*, Change>> changes{
      {"moved by a hundred radii",
       [](Certificate& c, std::size_t i) {
         c.balls[i].x_real = c.balls[i].x_real + power_of_ten(c.balls[i].radius_exponent + 2);
         return true;
       }},
      {"moved far away",
       [](Certificate& c, std::size_t i) {
         c.balls[i].y_real = c.balls[i].y_real + Rational(3) / Rational(7);
         return true;
       }},
      {"moved off the real plane",
       [](Certificate& c, std::size_t i) {
         c.balls[i].y_imaginary = c.balls[i].y_imaginary + power_of_ten(c.balls[i].radius_exponent + 2);
         return true;
       }},
      {"dropped",
       [](Certificate& c, std::size_t i) {
         c.balls.erase(c.balls.begin() + static_cast<std::ptrdiff_t>(i));
         return true;
       }},
      {"dropped, and said to be at infinity",
       [](Certificate& c, std::size_t i) {
         c.at_infinity += c.balls[i].multiplicity;
         c.balls.erase(c.balls.begin() + static_cast<std::ptrdiff_t>(i));
         return true;
       }},
      {"said twice",
       [](Certificate& c, std::size_t i) {
         c.balls.push_back(c.balls[i]);
         return true;
       }},
      {"another multiplicity",
       [](Certificate& c, std::size_t i) {
         ++c.balls[i].multiplicity;
         return true;
       }},
      {"another multiplicity, the sum kept by infinity",
       [](Certificate& c, std::size_t i) {
         if (c.at_infinity == 0) return false;
         ++c.balls[i].multiplicity;
         --c.at_infinity;
         return true;
       }},
      {"exchanged multiplicities",
       [](Certificate& c, std::size_t i) {
         const std::size_t j = (i + 1) % c.balls.size();
         if (c.balls[i].multiplicity == c.balls[j].multiplicity) return false;
         std::swap(c.balls[i].multiplicity, c.balls[j].multiplicity);
         return true;
       }},
      {"a multiple solution torn into simple ones",
       [](Certificate& c, std::size_t i) {
         if (c.balls[i].multiplicity == 1) return false;
         CertifiedBall other = c.balls[i];
         other.multiplicity = c.balls[i].multiplicity - 1;
         other.x_real = other.x_real + power_of_ten(other.radius_exponent + 1);
         c.balls[i].multiplicity = 1;
         c.balls.push_back(other);
         return true;
       }},
      {"the other reality",
       [](Certificate& c, std::size_t i) {
         c.balls[i].real = !c.balls[i].real;
         return true;
       }},
      {"a ball as large as the plane",
       [](Certificate& c, std::size_t i) {
         if (c.balls.size() == 1) return false;  // true, where there is no other solution
         c.balls[i].radius_exponent = 3;
         return true;
       }},
  };
  for (const System& system : systems) {
    CAPTURE(std::string(system.p));
    CAPTURE(std::string(system.q));
    const PlaneCurvesProblem input = problem(system.p, system.q);
    const Certificate certificate = certificate_of(input);
    for (const auto& [what, change] : changes)
      for (std::size_t i = 0; i < certificate.balls.size(); ++i) {
        CAPTURE(std::string(what));
        CAPTURE(i);
        Certificate corrupted = certificate;
        if (change(corrupted, i)) CHECK(!check(input, corrupted).empty());
      }
  }
}

TEST_CASE("Certificate: what is said of the whole is checked, too") {
  const PlaneCurvesProblem input = problem("(x-1)^2+y^2-1", "x*(y-2)");
  const Certificate certificate = certificate_of(input);
  REQUIRE(certificate.shears.size() == 2);
  const auto refused = [&](const std::function<void(Certificate&)>& change) {
    Certificate corrupted = certificate;
    change(corrupted);
    return !check(input, corrupted).empty();
  };
  CHECK(refused([](Certificate& c) { c.shears.clear(); }));
  CHECK(refused([](Certificate& c) { c.shears.pop_back(); }));
  CHECK(refused([](Certificate& c) { c.shears[1] = c.shears[0]; }));
  CHECK(refused([](Certificate& c) { c.shears.push_back(17); }));
  CHECK(refused([](Certificate& c) { c.shears[0] = 0; }));  // x does not separate the points
  CHECK(refused([](Certificate& c) { ++c.at_infinity; }));
  CHECK(refused([](Certificate& c) { c.p = curve("(x-1)^2+y^2-2"); }));
  CHECK(refused([](Certificate& c) { std::swap(c.p, c.q); }));
  CHECK(refused([](Certificate& c) { c.common_component = curve("x-1"); }));
  CHECK(refused([](Certificate& c) { c.common_component = curve("2"); }));
  CHECK(refused([](Certificate& c) { c.common_component = curve("0"); }));
  CHECK(refused([](Certificate& c) { c.balls.clear(); }));

  const PlaneCurvesProblem shared = problem("(x-y)*(x^2+y^2-1)", "(x-y)*(x-2)");
  Certificate component = certificate_of(shared);
  CHECK(check(shared, component).empty());
  component.common_component.reset();
  CHECK(!check(shared, component).empty());
  const PlaneCurvesProblem square = problem("(x-y)^2*(x+1)", "(x-y)^2*(y+1)");
  Certificate partial = certificate_of(square);
  partial.common_component = curve("x-y");  // divides both, but is not all
  CHECK(!check(square, partial).empty());
}

TEST_CASE("Certificate: a ball beside its solution is refused, however far from the origin or near to the border") {
  const auto refused = [](const PlaneCurvesProblem& input, const Rational& x, long radius_exponent) {
    Certificate certificate;
    certificate.p = input.p;
    certificate.q = input.q;
    CertifiedBall ball;
    ball.x_real = x;
    ball.radius_exponent = radius_exponent;
    ball.real = true;
    certificate.balls.push_back(ball);
    return !check(input, certificate).empty();
  };
  const Rational far(symbolic::power(symbolic::Integer(2), 700));
  const PlaneCurvesProblem distant = problem("x-2^700", "y");
  CHECK_FALSE(refused(distant, far, 0));
  for (const unsigned long exponent : {1UL, 100UL, 187UL})
    CHECK(refused(distant, far + Rational(symbolic::power(symbolic::Integer(2), exponent)), 0));
  const PlaneCurvesProblem origin = problem("x", "y");
  CHECK_FALSE(refused(origin, Rational(1) / Rational(2) * power_of_ten(-30), -30));
  CHECK(refused(origin, power_of_ten(-30) + power_of_ten(-39), -30));
}

TEST_CASE("Certificate: other names, and a component of two zero polynomials") {
  const PlaneCurvesProblem input = problem("x-1", "y-2");
  Certificate certificate = certificate_of(input);
  certificate.variables = {"y", "x"};
  CHECK(!check(input, certificate).empty());
  const PlaneCurvesProblem plane = problem("0", "0");
  Certificate component = certificate_of(plane);
  component.common_component = curve("x");
  CHECK(!check(plane, component).empty());
}

TEST_CASE("Certificate: solutions of very different sizes") {
  for (const auto& [p, q] : {std::pair{"x^2-10^(-320)", "y^2*(y-1)"},
                             {"x^2*(x-10^160)", "y^2-y"},
                             {"x*(x-1)^2*(x-10^200)", "y^2-2"},
                             {"(x^2-2*10^(-300))^2", "(y^2-3*10^300)^3"}}) {
    CAPTURE(std::string(p));
    const PlaneCurvesProblem input = problem(p, q);
    CHECK(check(input, certificate_of(input)).empty());
  }
}

TEST_CASE("Certificate: constants and zero polynomials") {
  for (const auto& [p, q] : {std::pair{"0", "0"}, {"0", "x-y"}, {"0", "3"}, {"2", "x"}, {"x^2-y", "x^2-y"}}) {
    CAPTURE(std::string(p));
    CAPTURE(std::string(q));
    const PlaneCurvesProblem input = problem(p, q);
    Certificate certificate = certificate_of(input);
    CHECK(check(input, certificate).empty());
    CertifiedBall invented;
    invented.real = true;
    certificate.balls.push_back(invented);
    CHECK(!check(input, certificate).empty());
  }
  const PlaneCurvesProblem input = problem("0", "x-y");
  Certificate certificate = certificate_of(input);
  certificate.common_component.reset();
  CHECK(!check(input, certificate).empty());
}

TEST_CASE("Certificate: of all solutions, also when a box lists only some") {
  PlaneCurvesProblem input = problem("x^2+y^2-5", "x*y-2");
  input.box = Box{{Rational(0), Rational(1)}, {Rational(0), Rational(3)}};
  Options options;
  options.certificate = true;
  const Result result = solve(input, options);
  CHECK(result.solutions.size() == 1);
  REQUIRE(result.certificate.has_value());
  CHECK(result.certificate->balls.size() == 4);
}
