// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>

#include <eliminant/base/error.hpp>
#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/input/problem_echo.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/results/cylinders_csv.hpp>
#include <eliminant/io/results/cylinders_json.hpp>
#include <eliminant/io/results/cylinders_text.hpp>

using namespace eliminant;
using namespace eliminant::io;
using intersect::CylinderSolution;
using intersect::CylindersResult;

namespace {

ProblemFile read(const std::string& text) { return read_problem(text, ProblemSyntax::json); }

/// One real cylinder of radius 3 and one that is not real.
CylindersResult sample() {
  CylindersResult result;
  result.status = intersect::Status::certified;
  result.counts = {.distinct = 2, .real = 1, .with_multiplicity = 4, .isotropic = 2, .bezout_number = 6, .listed = 2};
  CylinderSolution real;
  const auto number = [](const std::string& re, const std::string& im) {
    return intersect::Coordinate{{}, re, im, std::nullopt};
  };
  real.direction = {number("0.8", "0"), number("0", "0"), number("-0.6", "0")};
  real.axis_point = {number("1", "0"), number("2", "0"), number("3", "0")};
  real.radius_squared = number("9", "0");
  real.radius = number("3", "0");
  real.direction_error_exponent = -15;
  real.axis_point_error_exponent = -14;
  real.radius_squared_error_exponent = -13;
  real.radius_error_exponent = -12;
  real.residual_exponent = -11;
  real.reality = intersect::Reality::real;
  real.multiplicity = 3;
  real.certified = true;
  CylinderSolution other = real;
  other.direction[0] = number("0", "-0.8");
  other.radius_squared = number("-9", "1");
  other.radius.reset();
  other.residual_exponent.reset();
  other.reality = intersect::Reality::non_real;
  other.multiplicity = 1;
  result.solutions = {real, other};
  return result;
}

struct Refusal {
  std::string message, expected;
  std::size_t line = 0, column = 0;
};

Refusal refused(const std::string& text) {
  try {
    read(text);
  } catch (const InvalidInput& error) {
    return {error.what(), error.expected(), error.place().line, error.place().column};
  }
  return {};
}

}  // namespace

TEST_CASE("Cylinders: a problem is read and echoed") {
  const ProblemFile file = read(
      R"({"problem": "cylinders", "id": 3, "points": [[0, 0.1, "1/3"], [1, 1, 0], [1, 0, 1], [0, 1, 1], ["4/3", -1e-3, "0x1p-1"]]})");
  const auto& problem = std::get<intersect::CylindersProblem>(file.problem);
  CHECK(problem.points[0][1].to_string() == "1/10");
  CHECK(problem.points[0][2].to_string() == "1/3");
  CHECK(problem.points[4][1].to_string() == "-1/1000");
  CHECK(problem.points[4][2].to_string() == "1/2");
  const std::string echoed = echo_problem(file, {});
  CHECK(std::get<intersect::CylindersProblem>(read(echoed).problem).points == problem.points);
  CHECK(echo_problem(read(echoed), {}) == echoed);
}

TEST_CASE("Cylinders: bad problems are refused with the place and what was expected") {
  const Refusal missing = refused(R"({"problem": "cylinders"})");
  CHECK(missing.message == "the field \"points\" is missing");
  CHECK(missing.expected == "five points [x, y, z]");
  const Refusal four = refused("{\"problem\": \"cylinders\",\n\"points\": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]}");
  CHECK(four.message == "\"points\" holds 4 points");
  CHECK(four.expected == "five points [x, y, z]");
  CHECK(four.line == 2);
  CHECK(four.column == 11);
  const Refusal six =
      refused(R"({"problem": "cylinders", "points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1],[1,1,1],[2,2,2]]})");
  CHECK(six.message == "\"points\" holds 6 points");
  const Refusal plane = refused("{\"problem\": \"cylinders\",\n\"points\": [[0,0,0],[1,0,0],\n[0,1],[0,0,1],[1,1,1]]}");
  CHECK(plane.message == "point 3 has 2 numbers");
  CHECK(plane.expected == "[x, y, z]");
  CHECK(plane.line == 3);
  CHECK(plane.column == 1);
  const Refusal flat = refused(R"({"problem": "cylinders", "points": [0, 1, 2, 3, 4]})");
  CHECK(flat.message == "point 1 is a number");
  const Refusal object = refused(R"({"problem": "cylinders", "points": {"x": 1}})");
  CHECK(object.message == "\"points\" is an object");
  const Refusal word = refused(R"({"problem": "cylinders", "points": [[0,0,0],[1,0,0],[0,1,0],[0,0,"one"],[1,1,1]]})");
  CHECK(word.message.starts_with("z of point 4: "));
  CHECK(word.column == 67);
  const Refusal null = refused(R"({"problem": "cylinders", "points": [[0,0,0],[1,null,0],[0,1,0],[0,0,1],[1,1,1]]})");
  CHECK(null.message == "y of point 2 is null");
  const Refusal infinite =
      refused(R"({"problem": "cylinders", "points": [[0,0,0],[1,"inf",0],[0,1,0],[0,0,1],[1,1,1]]})");
  CHECK(infinite.message.starts_with("y of point 2: "));
  CHECK(refused(R"({"problem": "cylinders", "points": [], "box": []})").message == "unknown field \"box\"");
}

TEST_CASE("Cylinders: results as JSON") {
  const JsonDocument document(cylinders_json(sample(), ProblemId(std::string("five"))));
  const JsonValue& root = document.root();
  CHECK(root.find("problem")->text == "cylinders");
  CHECK(root.find("id")->text == "five");
  CHECK(root.find("counts")->find("isotropic")->text == "2");
  REQUIRE(root.find("solutions")->elements.size() == 2);
  const JsonValue& real = root.find("solutions")->elements[0];
  CHECK(real.find("direction")->elements[2].elements[0].text == "-0.6");
  CHECK(real.find("radius")->text == "3");
  CHECK(real.find("error")->find("radius")->text == "1e-12");
  CHECK(real.find("residual")->text == "1e-11");
  const JsonValue& other = root.find("solutions")->elements[1];
  CHECK(other.find("radius")->kind == JsonValue::Kind::null);
  CHECK(other.find("error")->find("radius") == nullptr);
  CHECK(other.find("residual")->text == "0");
  CHECK(other.find("direction")->elements[0].elements[1].text == "-0.8");
}

TEST_CASE("Cylinders: infinitely many as JSON and text") {
  CylindersResult result;
  result.status = intersect::Status::infinite;
  result.degeneracy = "two of the points are the same";
  result.directions = symbolic::Polynomial::variable(3, 0) * symbolic::Polynomial::variable(3, 2);
  const JsonDocument document(cylinders_json(result, std::nullopt));
  CHECK(document.root().find("degeneracy")->text == "two of the points are the same");
  CHECK(document.root().find("directions")->text == "x*z");
  const std::string text = cylinders_text(result, {});
  CHECK(text.find("Status: infinite: infinitely many cylinders pass through the points") == 0);
  CHECK(text.find("  x*z = 0\n") != std::string::npos);
}

TEST_CASE("Cylinders: results as CSV") {
  const std::string csv = cylinders_csv(sample());
  CHECK(csv.substr(csv.find('\n') + 1) ==
        "0.8,0,0,0,-0.6,0,1,0,2,0,3,0,9,0,3,1e-15,1e-14,1e-13,1e-12,1e-11,true,3,true\n"
        "0,-0.8,0,0,-0.6,0,1,0,2,0,3,0,-9,1,,1e-15,1e-14,1e-13,,0,false,1,true\n");
}

TEST_CASE("Cylinders: results as text") {
  const std::string text = cylinders_text(sample(), {});
  CHECK(text.find("  = 4  cylinders (2 different)\n") != std::string::npos);
  CHECK(text.find("THE SUM FAILS") == std::string::npos);
  CHECK(text.find("(0.8, 0, -0.6)") != std::string::npos);
  CHECK(text.find("(-0.8i, 0, -0.6)") != std::string::npos);
  CHECK(text.find("-9 + 1i") != std::string::npos);
  CylindersResult empty;
  empty.status = intersect::Status::certified;
  CHECK(cylinders_text(empty, {}).find("There is no cylinder through these points.") != std::string::npos);
}
