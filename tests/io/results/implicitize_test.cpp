// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/io/input/problem_echo.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/results/implicitize_json.hpp>
#include <eliminant/io/results/implicitize_text.hpp>

using namespace eliminant;
using namespace eliminant::io;
using intersect::ImplicitizeProblem;
using intersect::ImplicitizeResult;
using nlohmann::json;

namespace {

const std::string sphere =
    R"({"parameters": ["s", "t", "u"], "x": "s^2+t^2+u^2", "y": "2*s*u", "z": "2*s*t", "w": "s^2-t^2-u^2"})";
const std::string circle = R"({"parameter": "t", "x": "1-t^2", "y": "2*t", "w": "1+t^2"})";

ProblemFile read(const std::string& text, bool bare = false) {
  ReadSettings settings;
  settings.bare_geometry = bare;
  return read_problem(text, ProblemSyntax::json, settings);
}

ImplicitizeResult solve(const std::string& text, bool equation = true) {
  intersect::Options options;
  options.equation = equation;
  return intersect::implicitize(std::get<ImplicitizeProblem>(read(text, true).problem), options, Context());
}

bool is_surface(const ProblemFile& file) {
  return std::holds_alternative<symbolic::ParametricSurface>(std::get<ImplicitizeProblem>(file.problem).geometry);
}

void check_refused(const std::string& text, bool bare, const std::string& message, const std::string& expected) {
  CAPTURE(text);
  try {
    read(text, bare);
    FAIL_CHECK("not refused");
  } catch (const InvalidInput& error) {
    CAPTURE(error.what());
    CAPTURE(error.expected());
    CHECK(std::string(error.what()).find(message) != std::string::npos);
    CHECK(error.expected().find(expected) != std::string::npos);
    CHECK(error.place().line == 1);
  }
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("implicitize problems: a curve or surface with its kind, without it, or alone") {
  const ProblemFile file =
      read(R"({"problem": "implicitize", "id": 7, "surface": )" + sphere + R"(, "options": {"equation": true}})");
  CHECK(is_surface(file));
  CHECK(std::get<long>(*file.id) == 7);
  REQUIRE(file.options.size() == 1);
  CHECK(file.options.front().name == "equation");
  CHECK_FALSE(is_surface(read(R"({"problem": "implicitize", "curve": )" + circle + "}")));
  CHECK(is_surface(read("{\"surface\": " + sphere + "}", true)));
  CHECK_FALSE(is_surface(read("{\"curve\": " + circle + ", \"id\": \"c\"}", true)));
  CHECK(is_surface(read(sphere, true)));
  CHECK_FALSE(is_surface(read(circle, true)));
  CHECK_FALSE(is_surface(read(R"({"bezier": {"degree": 1, "control_points": [[0, 0], [1, 2]]}})", true)));
  CHECK(is_surface(read(
      R"({"bezier": {"degree": [1, 1], "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]}})", true)));
  CHECK(is_surface(read(R"({"triangle": {"degree": 1, "control_points": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}})", true)));
  CHECK(is_surface(read(
      R"({"pieces": [{"parameters": ["s", "t"], "x": "s", "y": "t", "z": "0", "domain": [[0, 1], [0, 1]]}]})", true)));
  CHECK_FALSE(is_surface(read(R"({"pieces": [{"parameter": "t", "x": "t", "y": "0", "domain": [0, 1]}]})", true)));
}

TEST_CASE("implicitize problems: what is none is refused with its place") {
  check_refused(R"({"problem": "implicitize"})", false, "\"curve\" or \"surface\" is missing", "one curve or one");
  check_refused("{\"curve\": " + circle + ", \"surface\": " + sphere + "}", true, "are both there", "one curve or one");
  check_refused(R"({"problem": "implicitize", "p": "x"})", false, "unknown field \"p\"", "surface");
  check_refused(R"({"curve": {"implicit": "x^2 - y"}})", true, "given by its equation already", "Bezier");
  check_refused(R"({"surface": {"implicit": "x^2 - y"}})", true, "given by its equation already", "Bezier");
  check_refused(R"({"implicit": "x^2 - y"})", true, "given by its equation already", "Bezier");
  check_refused("{}", true, "\"parameter\"", "\"parameter\"");
  check_refused("[]", true, "the problem is an array", "an object");
  check_refused(circle, false, "\"problem\" is missing", "plane_curves");
  check_refused(R"({"parameter": "t", "x": "1", "y": "2"})", true, "the curve is a single point", "not constant");
  check_refused(R"({"parameters": ["s", "t"], "x": "s", "y": "s", "z": "1"})", true, "only a curve", "independent");
  ReadSettings settings;
  settings.bare_geometry = true;
  settings.variables = {"x", "y"};
  CHECK_THROWS_AS(read_problem(circle, ProblemSyntax::json, settings), InvalidInput);
}

TEST_CASE("implicitize problems: --echo prints what gives the same problem") {
  for (const std::string& text : {sphere, circle}) {
    const ProblemFile file = read(text, true);
    RunOptions options;
    options.solve.equation = true;
    const std::string echo = echo_problem(file, options);
    CHECK(json::parse(echo).at("problem") == "implicitize");
    const ProblemFile back = read(echo);
    CHECK(echo_problem(back, options) == echo);
    CHECK(is_surface(back) == is_surface(file));
    CHECK(back.options.size() == 1);
  }
}

TEST_CASE("implicitize results as JSON: a sphere") {
  const json result = json::parse(implicitize_json(solve(sphere), ProblemId("ball")));
  CHECK(result.at("format") == 1);
  CHECK(result.at("problem") == "implicitize");
  CHECK(result.at("id") == "ball");
  CHECK(result.at("status") == "certified");
  CHECK(result.at("counts") == json{{"pieces", 1}});
  CHECK(result.at("warnings").empty());
  CHECK(result.at("seconds").contains("total"));
  CHECK(result.at("engine").at("matrix") == "moving planes");
  const json& piece = result.at("representations").at(0);
  CHECK(piece.at("kind") == "triangular_surface");
  CHECK(piece.at("nu") == json{1});
  CHECK(piece.at("rows") == 3);
  CHECK(piece.at("columns") == 4);
  CHECK(piece.at("rank") == 3);
  CHECK(piece.at("rank_on") == 2);
  CHECK(piece.at("degree") == 2);
  CHECK(piece.at("map_degree") == 1);
  CHECK(piece.at("product") == 2);
  CHECK(piece.at("minors") == 2);
  CHECK(piece.at("extraneous") == false);
  CHECK(piece.at("proven") == true);
  CHECK(piece.at("row_monomials") == json{"s", "t", "u"});
  CHECK(piece.at("matrix").size() == 3);
  CHECK(piece.at("matrix").at(0).size() == 4);
  CHECK(piece.at("equation") == "x^2 - y^2 - z^2 - w^2");
  CHECK_FALSE(json::parse(implicitize_json(solve(sphere, false), {})).at("representations").at(0).contains("equation"));
}

TEST_CASE("implicitize results as JSON: curves, pieces with domains, and a limit") {
  const json plane = json::parse(implicitize_json(solve(circle), {}));
  CHECK(plane.at("representations").at(0).at("kind") == "plane_curve");
  CHECK(plane.at("representations").at(0).at("equation") == "x^2 + y^2 - w^2");
  CHECK(plane.at("representations").at(0).at("x") == "-t^2 + 1");
  const json space =
      json::parse(implicitize_json(solve(R"({"parameter": "t", "x": "t", "y": "t^2", "z": "t^3"})", false), {}));
  CHECK(space.at("representations").at(0).at("kind") == "space_curve");
  CHECK_FALSE(space.at("representations").at(0).contains("minors"));
  const json nurbs = json::parse(implicitize_json(solve(R"({"nurbs": {"degree": 2, "knots": [0, 0, 0, "1/2", 1, 1, 1],
                "control_points": [[0, 0], [1, 2], [3, 1], [4, 0]]}})"),
                                                  {}));
  REQUIRE(nurbs.at("representations").size() == 2);
  CHECK(nurbs.at("counts").at("pieces") == 2);
  CHECK(nurbs.at("representations").at(1).at("domain") == json{"1/2", "1"});
  ImplicitizeResult limited = solve(sphere, false);
  limited.status = intersect::Status::incomplete;
  limited.limit = "too large";
  const json incomplete = json::parse(implicitize_json(limited, {}));
  CHECK(incomplete.at("status") == "incomplete");
  CHECK(incomplete.at("error").at("message") == "too large");
  CHECK(contains(implicitize_text(limited), "Status: incomplete: too large"));
}

TEST_CASE("implicitize results as text: facts, matrix and equation") {
  const std::string text = implicitize_text(solve(sphere), false);
  CHECK(contains(text, "Status: certified"));
  CHECK(contains(text, "3 x 4"));
  CHECK(contains(text, "3 in general, 2 on the surface (modulo a 62-bit prime)"));
  CHECK(contains(text, "x^2 - y^2 - z^2 - w^2 = 0"));
  CHECK(contains(text, "s, t, u"));
  CHECK_FALSE(contains(text, "seconds"));
  // A wide matrix is printed by columns.
  const std::string wide = implicitize_text(
      solve(
          R"({"parameters": ["s", "t"], "x": "12345*s^2*t^2+s+1", "y": "777*s*t^2-t+2", "z": "s^2+991*t+3", "w": "s+t+45678"})",
          false),
      false);
  CHECK(contains(wide, "column 1\n"));
  CHECK(contains(wide, "tensor-product surface"));
}
