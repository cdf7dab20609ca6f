// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/io/problem_echo.hpp>
#include <eliminant/io/problem_file.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <random>

using namespace eliminant;
using namespace eliminant::io;
using symbolic::Integer;
using symbolic::Rational;

namespace {

ProblemFile read(const std::string& text) { return read_problem(text, ProblemSyntax::json); }

std::vector<std::string> variables_of(const std::string& p, const std::string& q) {
  return problem_from_arguments(p, q, std::nullopt).problem.variables;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("read_problem: all fields of a plane_curves problem") {
  const ProblemFile file = read(R"({"problem": "plane_curves", "id": "first", "variables": ["u", "v"],
    "p": "uv - 0.1", "q": 1e-400, "box": [[-2, "1/3"], [0.1, 1e400]],
    "options": {"digits": 30, "real": true, "engine": "exact", "time-limit": 2.5}})");
  CHECK(std::get<std::string>(*file.id) == "first");
  CHECK(file.problem.variables == Names{"u", "v"});
  CHECK(to_string(file.problem.p, file.problem.variables) == "u*v - 1/10");
  CHECK(file.problem.q.constant_term() == Rational(1) / Rational(symbolic::power(Integer(10), 400)));
  CHECK(file.problem.box->x[1] == Rational(Integer(1), Integer(3)));
  CHECK(file.problem.box->y[1] == Rational(symbolic::power(Integer(10), 400)));
  RunOptions options;
  apply_options(options, file.options);
  CHECK(options.solve.digits == 30);
  CHECK(options.solve.field == intersect::Field::real);
  CHECK(options.solve.engine == intersect::Engine::exact);
  CHECK(*options.time_limit_seconds == 2.5);
}

TEST_CASE("variables: the names that occur, sorted, completed by x, then y") {
  CHECK(variables_of("x^2 - 1", "y") == Names{"x", "y"});
  CHECK(variables_of("b", "a") == Names{"a", "b"});
  CHECK(variables_of("t - 1", "t + 1") == Names{"t", "x"});
  CHECK(variables_of("x", "1") == Names{"x", "y"});
  CHECK(variables_of("y", "1") == Names{"y", "x"});
  CHECK(variables_of("1", "0") == Names{"x", "y"});
  CHECK(variables_of("y*z", "z") == Names{"y", "z"});
  CHECK_THROWS_AS(variables_of("x*y", "z"), InvalidInput);
  // A product without a sign is a product of names of one letter that occur, or of x and y.
  CHECK(variables_of("x + xy", "y") == Names{"x", "y"});
  CHECK(variables_of("xy - 1", "1") == Names{"x", "y"});
  CHECK(variables_of("uv - 1", "u - v") == Names{"u", "v"});
  CHECK(variables_of("uv - 1", "u") == Names{"u", "uv"});
}

TEST_CASE("read_problem: the id is known even when the rest is refused") {
  std::optional<ProblemId> id;
  CHECK_THROWS_AS(read_problem(R"({"id": 12, "problem": "plane_curves"})", ProblemSyntax::json, {}, &id), InvalidInput);
  CHECK(std::get<long>(*id) == 12);
}

TEST_CASE("read_problem: msolve's format with two polynomials") {
  const ProblemFile file = read_problem("x, y\r\n0\r\nx^2 + x^2\r\n - y/2,\r\n2*x*y - 1\r\n", ProblemSyntax::msolve);
  CHECK(to_string(file.problem.p, file.problem.variables) == "2*x^2 - 1/2*y");
  CHECK(to_string(file.problem.q, file.problem.variables) == "2*x*y - 1");
  CHECK(problem_syntax("a.ms", "") == ProblemSyntax::msolve);
  CHECK(problem_syntax("-", "x,y\n0\nx,y") == ProblemSyntax::msolve);
  CHECK(problem_syntax("-", " {\"problem\": \"plane_curves\"}") == ProblemSyntax::json);
}

TEST_CASE("options: later settings win, as the command line over the problem") {
  RunOptions options;
  apply_options(options,
                std::vector<OptionSetting>{{"digits", "30", {}}, {"real", "true", {}}, {"precision", "256", {}}});
  apply_options(options, std::vector<OptionSetting>{{"digits", "50", {}}, {"complex", "true", {}}});
  CHECK(options.solve.digits == 50);
  CHECK(options.solve.field == intersect::Field::complex);
  CHECK(options.solve.precision_bits == 256);
}

TEST_CASE("echo_problem: random problems are read back unchanged") {
  std::mt19937_64 random(11);
  for (int round = 0; round < 200; ++round) {
    ProblemFile file;
    file.problem.variables = random() % 2 == 0 ? Names{"x", "y"} : Names{"β", "a_1"};
    for (symbolic::Polynomial* polynomial : {&file.problem.p, &file.problem.q}) {
      std::vector<symbolic::Polynomial::Term> terms(random() % 8);
      for (auto& term : terms)
        term = {Rational(Integer(static_cast<long>(random())), Integer(static_cast<long>(1 + random() % 999))),
                {random() % 9, random() % 9}};
      *polynomial = symbolic::Polynomial::from_terms(2, terms);
    }
    if (random() % 2 == 0)
      file.problem.box = intersect::Box{{Rational(Integer(-1), Integer(3)), Rational(2)}, {Rational(-7), Rational(-7)}};
    if (random() % 2 == 0) file.id = random() % 2 == 0 ? ProblemId("a \"quoted\" é") : ProblemId(-5L);
    RunOptions options;
    options.solve.digits = static_cast<long>(1 + random() % 50);
    options.solve.certify = random() % 2 == 0;
    options.solve.epsilon = 1e-8;
    options.solve.seed = random();
    options.solve.field = intersect::Field::real;
    options.memory_limit_megabytes = 100;

    const std::string text = echo_problem(file, options);
    CAPTURE(text);
    const ProblemFile back = read(text);
    CHECK(back.problem.variables == file.problem.variables);
    CHECK(back.problem.p == file.problem.p);
    CHECK(back.problem.q == file.problem.q);
    CHECK(back.id == file.id);
    CHECK(back.problem.box.has_value() == file.problem.box.has_value());
    if (back.problem.box) CHECK(back.problem.box->x == file.problem.box->x);
    RunOptions read_options;
    apply_options(read_options, back.options);
    CHECK(echo_problem(back, read_options) == text);
  }
}
