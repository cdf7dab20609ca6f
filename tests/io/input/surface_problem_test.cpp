// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <io/bad_geometry.hpp>
#include <io/geometry_text.hpp>

#include <eliminant/io/input/problem_echo.hpp>
#include <eliminant/io/results/surface_result_words.hpp>

using namespace eliminant;
using namespace eliminant::io;
using symbolic::Integer;
using symbolic::Interval;
using symbolic::ParametricSurface;
using symbolic::Polynomial;
using symbolic::Rational;

namespace {

ProblemFile read(const std::string& text) { return read_problem(text, ProblemSyntax::json); }

std::string pair(const std::string& first, const std::string& second) {
  return R"({"problem": "surface_surface", "first": )" + first + ",\n\"second\": " + second + "}";
}

std::string itself(const std::string& surface) {
  return R"({"problem": "self_intersection", "surface": )" + surface + "}";
}

const std::string saddle = R"({"parameters": ["s", "t"], "x": "s", "y": "t", "z": "s*t"})";
const std::string patch = R"({"bezier": {"degree": [1, 1],
  "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]}})";
const std::string roof = R"({"nurbs": {"degree": [1, 1], "knots": [[0, 0, 1, 3, 3], [0, 0, "1/2", "1/2"]],
  "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 1], [1, 1, 1]], [[2, 0, 0], [2, 1, 0]]]}})";
const std::string sphere = R"({"implicit": "x^2 + y^2 + z^2 - 1"})";

}  // namespace

TEST_CASE("Surface problems: two surfaces of every form, at most one of them an equation") {
  const auto maps = std::get<intersect::SurfaceSurfaceProblem>(read(pair(saddle, roof)).problem);
  CHECK(std::get<ParametricSurface>(maps.first).pieces.size() == 1);
  CHECK(std::get<ParametricSurface>(maps.second).pieces.size() == 2);
  const auto first = std::get<intersect::SurfaceSurfaceProblem>(read(pair(sphere, patch)).problem);
  CHECK(std::get<Polynomial>(first.first) == test::polynomials({"x^2+y^2+z^2-1"}, {"x", "y", "z"})[0]);
  CHECK(std::get<ParametricSurface>(first.second).pieces[0].region);
  const auto second = std::get<intersect::SurfaceSurfaceProblem>(read(pair(saddle, sphere)).problem);
  CHECK_FALSE(std::get<ParametricSurface>(second.first).pieces[0].region);
  CHECK(std::holds_alternative<Polynomial>(second.second));
  const auto triangle =
      read(itself(R"({"triangle": {"degree": 1, "control_points": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}})"));
  CHECK(std::get<intersect::SurfaceSelfIntersectionProblem>(triangle.problem).surface.pieces[0].region->triangle);
  // A curve is a problem of its own.
  const auto curve =
      read(R"({"problem": "self_intersection", "curve": {"parameter": "t", "x": "t^2 - 1", "y": "t^3 - t"}})");
  CHECK(std::holds_alternative<intersect::SelfIntersectionProblem>(curve.problem));
}

TEST_CASE("Surface problems: domains") {
  const auto maps = std::get<intersect::SurfaceSurfaceProblem>(read(pair(saddle, roof)).problem);
  const SurfaceDomains domains = domains_of(maps);
  CHECK_FALSE(domains[0]);
  CHECK_FALSE(domains[1]);
  CHECK(*domains[2] == Interval{0, 3});
  CHECK(*domains[3] == Interval{0, Rational(Integer(1), Integer(2))});
  const SurfaceDomains both = domains_of(intersect::SurfaceSelfIntersectionProblem{std::get<ParametricSurface>(
      std::get<intersect::SurfaceSurfaceProblem>(read(pair(sphere, patch)).problem).second)});
  for (const auto& domain : both) CHECK(domain == std::optional<Interval>(Interval{0, 1}));
}

TEST_CASE("Surface problems: the echo is a problem with the same echo") {
  const std::vector<std::string> surfaces{saddle, patch, roof};
  std::vector<std::string> texts{pair(sphere, patch), pair(roof, sphere)};
  for (const std::string& surface : surfaces) {
    texts.push_back(itself(surface));
    for (const std::string& other : surfaces) texts.push_back(pair(surface, other));
  }
  for (const std::string& text : texts) {
    CAPTURE(text);
    const ProblemFile file = read(text);
    const std::string echoed = echo_problem(file, {});
    const ProblemFile again = read(echoed);
    CHECK(again.problem.index() == file.problem.index());
    CHECK(echo_problem(again, {}) == echoed);
  }
}

TEST_CASE("Surface problems: tolerance and B-splines are options, echoed when they are not the defaults") {
  const std::string text = pair(saddle, patch);
  const ProblemFile file = read(text.substr(0, text.size() - 1) +
                                R"(, "options": {"tolerance": "1e-6", "bspline": true, "equation": true}})");
  RunOptions options;
  apply_options(options, file.options);
  CHECK(options.solve.tolerance == 1e-6);
  CHECK(options.solve.splines);
  CHECK(options.solve.equation);
  const ProblemFile again = read(echo_problem(file, options));
  RunOptions same;
  apply_options(same, again.options);
  CHECK(same.solve.tolerance == 1e-6);
  CHECK(same.solve.splines);
  CHECK(echo_problem(file, {}).find("options") == std::string::npos);
  const std::vector<OptionSetting> off{{"bspline", "false", {}}, {"tolerance", "1e-9", {}}};
  apply_options(same, off);
  CHECK_FALSE(same.solve.splines);
  CHECK(same.solve.tolerance == RunOptions{}.solve.tolerance);
}

TEST_CASE("Surface problems: bad tolerances are refused with what they can be") {
  for (const char* value : {"0", "-1e-9", "1", "2", "1e400", "nan", "inf", "", "1e-9 ", "1/2", "small", "0x1p-30"}) {
    CAPTURE(value);
    RunOptions options;
    const std::vector<OptionSetting> settings{{"tolerance", value, {}}};
    CHECK_THROWS_AS(apply_options(options, settings), InvalidInput);
  }
  for (const char* value : {"1e-15", "0.5", "1e-300"}) {
    RunOptions options;
    const std::vector<OptionSetting> settings{{"tolerance", value, {}}};
    CHECK_NOTHROW(apply_options(options, settings));
  }
}

TEST_CASE("Surface problems: bad input, with its place") {
  const std::string first = R"({"problem": "surface_surface", "first": )";  // 40 columns
  check_bad_inputs({
      {"no surfaces", R"({"problem": "surface_surface"})", invalid, 1, 1, "\"first\" is missing", "a surface"},
      {"no second surface", first + saddle + "}", invalid, 1, 1, "\"second\" is missing", "a surface"},
      {"two equations", pair(sphere, sphere), invalid, 2, 11, "\"first\" and \"second\" are both given by equations",
       "at least one surface with parameters"},
      {"a curve as surface", pair(R"({"parameter": "t", "x": "t", "y": "t", "z": "t"})", saddle), invalid, 1, 42,
       "unknown field \"parameter\"", "parameters, x"},
      {"an image that is a curve", pair(saddle, R"({"parameters": ["s", "t"], "x": "s", "y": "s^2", "z": "1"})"),
       invalid, 2, 11, "the image of \"second\" is only a curve", "two independent parameters"},
      {"too few rows",
       pair(R"({"bezier": {"degree": [2, 1], "control_points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]}})", saddle),
       invalid, 1, 89, "2 rows of control points for the first degree 2", "3 rows"},
      {"too many points in a row",
       pair(R"({"bezier": {"degree": [1, 1], "control_points": [[[0,0,0],[0,1,0],[0,2,0]],[[1,0,0],[1,1,1]]]}})",
            saddle),
       invalid, 1, 90, "a row of 3 control points for the second degree 1", "2 points"},
      {"too few points of a triangle",
       itself(R"({"triangle": {"degree": 2, "control_points": [[0,0,0],[0,1,0],[1,0,0]]}})"), invalid, 1, 90,
       "3 control points for a triangle of degree 2", "6 points"},
      {"knots and points do not agree",
       itself(
           R"({"nurbs": {"degree": [1, 1], "knots": [[0,0,1], [0,0,1,1]], "control_points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]}})"),
       invalid, 1, 84, "3 knots", "4"},
      {"a point of two coordinates",
       pair(saddle, R"({"bezier": {"degree": [1, 1], "control_points": [[[0,0],[0,1,0]],[[1,0,0],[1,1,1]]]}})"),
       invalid, 2, 61, "2 ", "[x, y, z]"},
      {"a constant equation", pair(saddle, R"({"implicit": "1"})"), invalid, 2, 24, "\"implicit\" is constant",
       "one of its variables"},
      {"an equation with another variable", pair(saddle, R"({"implicit": "x*w"})"), parse, 2, 27,
       "unknown variable 'w'", "x, y, z"},
      {"a syntax error in a map", pair(R"({"parameters": ["s", "t"], "x": "s +* t", "y": "t", "z": "0"})", saddle),
       parse, 1, 77, "x: unexpected '*'", "a number"},
      {"an empty domain",
       pair(R"({"parameters": ["s", "t"], "x": "s", "y": "t", "z": "0", "domain": [[0, 1], [2, 1]]})", saddle), invalid,
       1, 117, "is empty", "lower <= upper"},
      {"nothing with itself", R"({"problem": "self_intersection"})", invalid, 1, 1,
       "\"curve\" or \"surface\" is missing", "one curve or one surface"},
      {"curve and surface",
       R"({"problem": "self_intersection", "curve": {"parameter": "t", "x": "t", "y": "0"}, "surface": )" + saddle +
           "}",
       invalid, 1, 1, "both there", "one curve or one surface"},
      {"an equation with itself", itself(sphere), invalid, 1, 45, "\"surface\" is given by an equation",
       "with parameters"},
      {"a text as surface", itself("\"sphere\""), invalid, 1, 45, "\"surface\" is a text", "a surface such as"},
      {"a degree beyond the limit", itself(R"({"bezier": {"degree": [600, 600], "control_points": []}})"), limit, 1, 67,
       "1200, beyond the limit", ""},
  });
}
