// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <random>
#include <string>
#include <vector>

using namespace eliminant;
using namespace eliminant::symbolic;

namespace {

const std::vector<std::string> xy{"x", "y"};

std::string read(const std::string& text) { return to_string(parse_polynomial(text, xy), xy); }

}  // namespace

TEST_CASE("parse_polynomial: ordinary notation is understood") {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"400*y^4 - 160*x^2*y^2 + 25/16", "-160*x^2*y^2 + 400*y^4 + 25/16"},
      {"2x^2y", "2*x^2*y"},
      {"x**2", "x^2"},
      {"xy", "x*y"},
      {"xy^2", "x*y^2"},
      {"xyx", "x^2*y"},
      {"(x-1)^3*(y+2)", "x^3*y + 2*x^3 - 3*x^2*y - 6*x^2 + 3*x*y + 6*x - y - 2"},
      {"(x+y)(x-y)", "x^2 - y^2"},
      {"x/2", "1/2*x"},
      {"3/4 x", "3/4*x"},
      {"x/2y", "1/2*x*y"},
      {"2e3", "2000"},
      {"2e3x", "2000*x"},
      {"0.1x", "1/10*x"},
      {"-x^2", "-x^2"},
      {"x - -y", "x + y"},
      {"x*-2", "-2*x"},
      {"2^3^2", "512"},
      {"2^-2 x", "1/4*x"},
      {"x^0", "1"},
      {"x^(1+1)", "x^2"},
      {" \t\nx\r\n", "x"},
      {"x/(1/2)", "2*x"},
      {"((((x))))", "x"},
      {"(-1)^(10^9)", "1"},
      {"x(y+1)", "x*y + x"}};
  for (const auto& [written, value] : cases) {
    const std::string text = written;
    CAPTURE(text);
    CHECK(read(text) == value);
  }
}

TEST_CASE("parse_polynomial: repeated monomials are added and may cancel") {
  CHECK(read("x^2 + x^2") == "2*x^2");
  CHECK(read("x*y - y*x") == "0");
  CHECK(read("0*x") == "0");
  CHECK(read("(x+1)^2 - x^2 - 2x - 1") == "0");
}

TEST_CASE("parse_polynomial: declared names win over products of them") {
  const std::vector<std::string> names{"a", "ab", "b"};
  CHECK(parse_polynomial("ab", names) == Polynomial::variable(3, 1));
  CHECK_THROWS_AS(parse_polynomial("aba", names), ParseError);  // a*b*a or ab*a
  const std::vector<std::string> greek{"α", "β"};
  CHECK(to_string(parse_polynomial("2αβ^2", greek), greek) == "2*α*β^2");
}

TEST_CASE("parse_polynomial: limits hold before anything is expanded") {
  const std::vector<const char*> too_large{"x^1001",
                                           "x^1000000000",
                                           "x^99999999999999999999999999",
                                           "((x^999)^999)^999",
                                           "(x+y+1)^1000*(x+1)",
                                           "(x+y+1)^1000 + (x+y+1)^1000*1.5 + (x+y+2)^1000",
                                           "2^(10^9)",
                                           "2^-(10^9)",
                                           "(2/3)^(10^9)",
                                           "9^9^9^9",
                                           "0*x^1001",
                                           "x^501*x^500",
                                           "(10^500*x + 3*y + 7)^1000",
                                           "1e1000001"};
  const auto begin = std::chrono::steady_clock::now();
  for (const char* text : too_large) {
    CAPTURE(text);
    try {
      parse_polynomial(text, xy);
      FAIL("accepted");
    } catch (const LimitReached& limit) {
      CHECK(limit.place().line == 1);
      CHECK(limit.place().column >= 1);
    }
  }
  const std::vector<std::string> four{"a", "b", "c", "d"};
  CHECK_THROWS_AS(parse_polynomial("(a+b+c+d+1)^100", four), LimitReached);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(2));
}

TEST_CASE("parse_polynomial: what is just within the limits is accepted") {
  CHECK(parse_polynomial("x^500*y^500", xy).total_degree() == 1000);
  CHECK(parse_polynomial("x^1000", xy).total_degree() == 1000);
  CHECK(parse_polynomial("(x+y)^1000", xy).term_count() == 1001);
  CHECK(parse_polynomial(std::string(500, '(') + "x" + std::string(500, ')'), xy) == Polynomial::variable(2, 0));
}

TEST_CASE("parse_polynomial: depth and length do not touch the stack") {
  CHECK_THROWS_AS(parse_polynomial(std::string(1'000'000, '('), xy), LimitReached);
  CHECK(read(std::string(1'000'000, '-') + "x") == "x");
  std::string tower = "2";
  for (int i = 0; i < 100'000; ++i) tower += "^1";
  CHECK(read(tower) == "2");
}

TEST_CASE("parse_polynomial: a long sum costs no more than its length") {
  std::string text = "0";
  for (int i = 0; i < 400; ++i)
    for (int j = 0; j < 400; ++j) text += " + 0.1*x^" + std::to_string(i) + "*y^" + std::to_string(j);
  const auto begin = std::chrono::steady_clock::now();
  CHECK(parse_polynomial(text, xy).term_count() == 160'000);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
}

TEST_CASE("parse_polynomial: places count code points and lines, through the caller's map") {
  const std::vector<std::string> greek{"α", "β"};
  try {
    parse_polynomial("α +\n αβ + *", greek);
    FAIL("accepted");
  } catch (const ParseError& error) {
    CHECK(error.place().line == 2);
    CHECK(error.place().column == 7);
  }
  try {
    parse_polynomial("x +", xy, {}, [](std::size_t offset) { return SourcePlace{40, 10 + offset}; });
    FAIL("accepted");
  } catch (const ParseError& error) {
    CHECK(error.place().line == 40);
    CHECK(error.place().column == 13);
  }
}

TEST_CASE("names_in: lists names once, in order, and refuses what looks like a function") {
  const auto names = names_in("b*a + b^2 + 2e3 + 2e");
  REQUIRE(names.size() == 3);
  CHECK(names[0].name == "b");
  CHECK(names[1].name == "a");
  CHECK(names[2].name == "e");
  CHECK(names[2].offset == 19);
  CHECK_THROWS_AS(names_in("sin(x)"), ParseError);
  CHECK_NOTHROW(names_in("x(y+1)"));
}

TEST_CASE("parse_polynomial: printed polynomials are read back unchanged") {
  std::mt19937_64 random(20240229);
  const auto below = [&](unsigned long bound) { return random() % bound; };
  for (int round = 0; round < 300; ++round) {
    const std::size_t variables = 1 + below(3);
    std::vector<std::string> names{"x", "y_1", "long"};
    names.resize(variables);
    std::vector<Polynomial::Term> terms(below(12));
    for (auto& term : terms) {
      Integer numerator(static_cast<long>(random()));
      if (below(5) == 0) numerator = power(numerator, below(20));
      term.coefficient = Rational(numerator, Integer(static_cast<long>(1 + below(1000))));
      for (std::size_t i = 0; i < variables; ++i) term.exponents.push_back(below(8));
    }
    const Polynomial p = Polynomial::from_terms(variables, terms);
    const std::string text = to_string(p, names);
    CAPTURE(text);
    CHECK(parse_polynomial(text, names) == p);
    // Redundant spaces and parentheses change nothing.
    CHECK(parse_polynomial("( " + text + " )^1 * 1", names) == p);
  }
}

TEST_CASE("parse_polynomial: a text evaluates like the arithmetic it writes") {
  // Random expressions, built twice: as text and by the operations of Polynomial.
  std::mt19937_64 random(7);
  struct Pair {
    std::string text;
    Polynomial value;
  };
  const auto build = [&](auto&& self, int depth) -> Pair {
    if (depth == 0) {
      switch (random() % 3) {
        case 0:
          return {"x", Polynomial::variable(2, 0)};
        case 1:
          return {"y", Polynomial::variable(2, 1)};
        default: {
          const long value = static_cast<long>(random() % 9);
          return {std::to_string(value) + ".5", Polynomial::constant(2, Rational(Integer(2 * value + 1), Integer(2)))};
        }
      }
    }
    const Pair a = self(self, depth - 1);
    switch (random() % 5) {
      case 0:
        return {"(" + a.text + ")^2", power(a.value, 2)};
      case 1:
        return {"-(" + a.text + ")/4", Rational(Integer(-1), Integer(4)) * a.value};
      default:
        break;
    }
    const Pair b = self(self, depth - 1);
    switch (random() % 3) {
      case 0:
        return {a.text + " + " + b.text, a.value + b.value};
      case 1:
        return {a.text + " - (" + b.text + ")", a.value - b.value};
      default:
        return {"(" + a.text + ")(" + b.text + ")", a.value * b.value};
    }
  };
  for (int round = 0; round < 200; ++round) {
    const Pair pair = build(build, 4);
    CAPTURE(pair.text);
    CHECK(parse_polynomial(pair.text, xy) == pair.value);
  }
}

TEST_CASE("parse_polynomial: garbage is refused, never crashes") {
  std::mt19937_64 random(99);
  const std::string alphabet = "xyz0123456789+-*/^(). e\n\t=,^*\xCE\xB1\xE2\x88\x92\x80p_";
  Limits limits;
  limits.total_digits = 1'000'000;
  for (int round = 0; round < 20'000; ++round) {
    std::string text(random() % 24, ' ');
    for (char& c : text) c = alphabet[random() % alphabet.size()];
    CAPTURE(text);
    try {
      const Polynomial p = parse_polynomial(text, xy, limits);
      CHECK(p.total_degree() <= 1000);
    } catch (const ParseError& error) {
      CHECK_FALSE(error.expected().empty());
      CHECK(error.place().line > 0);
    } catch (const LimitReached& limit) {
      CHECK(limit.place().line > 0);
    }
  }
}
