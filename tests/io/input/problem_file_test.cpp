// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/io/input/problem_echo.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <random>

using namespace eliminant;
using namespace eliminant::io;
using symbolic::Integer;
using symbolic::Rational;

namespace {

ProblemFile read(const std::string& text) { return read_problem(text, ProblemSyntax::json); }

const intersect::PlaneCurvesProblem& plane_curves(const ProblemFile& file) {
  return std::get<intersect::PlaneCurvesProblem>(file.problem);
}

std::vector<std::string> variables_of(const std::string& p, const std::string& q) {
  return plane_curves(problem_from_arguments(p, q, std::nullopt)).variables;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("read_problem: all fields of a plane_curves problem") {
  const ProblemFile file = read(R"({"problem": "plane_curves", "id": "first", "variables": ["u", "v"],
    "p": "uv - 0.1", "q": 1e-400, "box": [[-2, "1/3"], [0.1, 1e400]],
    "options": {"digits": 30, "real": true, "engine": "exact", "time-limit": 2.5}})");
  CHECK(std::get<std::string>(*file.id) == "first");
  CHECK(plane_curves(file).variables == Names{"u", "v"});
  CHECK(to_string(plane_curves(file).p, plane_curves(file).variables) == "u*v - 1/10");
  CHECK(plane_curves(file).q.constant_term() == Rational(1) / Rational(symbolic::power(Integer(10), 400)));
  CHECK(plane_curves(file).box->x[1] == Rational(Integer(1), Integer(3)));
  CHECK(plane_curves(file).box->y[1] == Rational(symbolic::power(Integer(10), 400)));
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
  CHECK(to_string(plane_curves(file).p, plane_curves(file).variables) == "2*x^2 - 1/2*y");
  CHECK(to_string(plane_curves(file).q, plane_curves(file).variables) == "2*x*y - 1");
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
    auto& problem = std::get<intersect::PlaneCurvesProblem>(file.problem);
    problem.variables = random() % 2 == 0 ? Names{"x", "y"} : Names{"β", "a_1"};
    for (symbolic::Polynomial* polynomial : {&problem.p, &problem.q}) {
      std::vector<symbolic::Polynomial::Term> terms(random() % 8);
      for (auto& term : terms)
        term = {Rational(Integer(static_cast<long>(random())), Integer(static_cast<long>(1 + random() % 999))),
                {random() % 9, random() % 9}};
      *polynomial = symbolic::Polynomial::from_terms(2, terms);
    }
    if (random() % 2 == 0)
      problem.box = intersect::Box{{Rational(Integer(-1), Integer(3)), Rational(2)}, {Rational(-7), Rational(-7)}};
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
    const ProblemFile file_back = read(text);
    const intersect::PlaneCurvesProblem& back = plane_curves(file_back);
    CHECK(back.variables == problem.variables);
    CHECK(back.p == problem.p);
    CHECK(back.q == problem.q);
    CHECK(file_back.id == file.id);
    CHECK(back.box.has_value() == problem.box.has_value());
    if (back.box) CHECK(back.box->x == problem.box->x);
    RunOptions read_options;
    apply_options(read_options, file_back.options);
    CHECK(echo_problem(file_back, read_options) == text);
  }
}

TEST_CASE("read_problem: a curve and a surface, with id and options") {
  const ProblemFile file = read(R"({"problem": "curve_surface", "id": "cubic",
    "curve": {"parameter": "t", "x": "1", "y": "t", "z": "t^2", "w": "t^3"},
    "surface": {"parameters": ["s", "t", "u"], "x": "s^2+t^2+u^2", "y": "2*s*u", "z": "2*s*t", "w": "s^2-t^2-u^2"},
    "options": {"digits": 30}})");
  CHECK(std::get<std::string>(*file.id) == "cubic");
  CHECK(file.options.size() == 1);
  const auto& problem = std::get<intersect::CurveSurfaceProblem>(file.problem);
  CHECK(problem.curve.pieces.at(0).map.degree() == 3);
  CHECK(std::get<symbolic::ParametricSurface>(problem.surface).pieces.at(0).map.degree() == 2);
}

TEST_CASE("read_problem: variables of the caller belong to plane_curves alone") {
  ReadSettings settings;
  settings.variables = Names{"u", "v"};
  const std::string curves = R"({"problem": "curve_curve", "first": {"implicit": "x"}, "second": {"implicit": "y"}})";
  CHECK_THROWS_AS(read_problem(curves, ProblemSyntax::json, settings), InvalidInput);
  settings.variables.reset();
  CHECK(read_problem(curves, ProblemSyntax::json, settings).problem.index() == 2);
}

TEST_CASE("echo_problem: curves and surfaces are read back unchanged") {
  const std::string curve = R"({"parameter": "v", "x": "v/2", "y": "v^2", "z": "1/3", "domain": ["-1/3", 2.5]})";
  const std::string cubic = R"({"bezier": {"degree": 2, "control_points": [[0,0,0],[1,0,0.5,2],[1,1,1]]}})";
  const std::string spline =
      R"({"nurbs": {"degree": 1, "knots": [0,0,1,3,3], "control_points": [[0,0,0],[1,0,0],[1,1,1]],
    "weights": [1, 2, 1]}})";
  const std::string sphere =
      R"({"parameters": ["a", "b", "c"], "x": "a^2+b^2+c^2", "y": "2ac", "z": "2ab", "w": "a^2-b^2-c^2"})";
  const std::string triangle = R"({"triangle": {"degree": 1, "control_points": [[0,0,0],[1,0,0,3],[0,1,7]]}})";
  const std::string saddle =
      R"({"parameters": ["s", "t"], "x": "s", "y": "t", "z": "s*t", "domain": [[0, 1], [-1, 1]]})";
  const std::string grid = R"({"nurbs": {"degree": [1, 1], "knots": [[0,0,1,2,2],[0,0,1,1]],
    "control_points": [[[0,0,0],[0,1,1]],[[1,0,0],[1,1,1,2]],[[2,0,1],[2,1,5]]]}})";
  std::vector<std::string> texts;
  for (const std::string& c : {curve, cubic, spline})
    for (const std::string& s : {sphere, triangle, saddle, grid, std::string(R"({"implicit": "x^2+y^2+z^2-1/4"})")})
      texts.push_back(R"({"problem": "curve_surface", "curve": )" + c + R"(, "surface": )" + s + "}");
  texts.push_back(R"({"problem": "curve_curve", "first": )" + spline + R"(, "second": )" + curve + "}");
  texts.push_back(R"({"problem": "curve_curve", "id": 3, "first": {"implicit": "x*y-1"},
    "second": {"bezier": {"degree": 1, "control_points": [[0, 0], [1, 1]]}}})");
  for (const std::string& c : {curve, cubic, spline, std::string(R"({"implicit": "y^2-x^3"})")})
    texts.push_back(R"({"problem": "self_intersection", "curve": )" + c + "}");
  for (const std::string& text : texts) {
    CAPTURE(text);
    const std::string echo = echo_problem(read(text), {});
    CAPTURE(echo);
    const ProblemFile back = read(echo);
    CHECK(echo_problem(back, {}) == echo);
    CHECK(back.problem.index() == read(text).problem.index());
  }
  const auto back = std::get<intersect::CurveSurfaceProblem>(read(echo_problem(read(texts[13]), {})).problem);
  CHECK(back.curve.pieces.size() == 2);
  CHECK(back.curve.pieces[1].domain == symbolic::Interval{1, 3});
  CHECK(std::get<symbolic::ParametricSurface>(back.surface).pieces.size() == 2);
}
