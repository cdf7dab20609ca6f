// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/input/stated_kind.hpp>
#include <eliminant/io/results/error_report.hpp>
#include <eliminant/io/results/result_csv.hpp>
#include <eliminant/io/results/result_json.hpp>
#include <eliminant/io/results/result_text.hpp>

using namespace eliminant;
using namespace eliminant::io;
using intersect::Reality;
using intersect::Result;
using intersect::Solution;
using intersect::Status;

namespace {

Solution solution(const char* x, const char* x_imaginary, const char* y, const char* y_imaginary, Reality reality) {
  Solution result;
  result.x.real = x;
  result.x.imaginary = x_imaginary;
  result.y.real = y;
  result.y.imaginary = y_imaginary;
  result.reality = reality;
  result.radius_exponent = -15;
  result.certified = reality == Reality::real;
  if (!result.certified) result.reason = "not tried";
  return result;
}

Result two_points() {
  Result result;
  result.status = Status::numeric;
  result.counts = {.distinct = 2, .real = 1, .with_multiplicity = 3, .at_infinity = 1, .bezout_number = 4, .listed = 2};
  result.solutions = {solution("-1.5", "0", "0.25", "0", Reality::real),
                      solution("0.5", "-1.25", "0", "2", Reality::undecided)};
  result.solutions[0].multiplicity = 2;
  result.engine.method = "exact";
  result.seconds = {{"total", 0.0012345678}, {"matrices", 0.0001}};
  result.warnings = {"a warning"};
  return result;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("result_json: the fields of format 1, in their order") {
  const std::string text = result_json(two_points(), ProblemId("my problem"));
  CHECK(text == R"({
 "format": 1,
 "problem": "plane_curves",
 "id": "my problem",
 "status": "numeric",
 "variables": ["x", "y"],
 "counts": {"distinct": 2, "real": 1, "undecided": 0, "with_multiplicity": 3, "at_infinity": 1, "bezout_number": 4, "listed": 2},
 "solutions": [
  {"x": ["-1.5", "0"], "y": ["0.25", "0"], "radius": "1e-15", "real": true, "multiplicity": 2, "certified": true},
  {"x": ["0.5", "-1.25"], "y": ["0", "2"], "radius": "1e-15", "real": null, "multiplicity": 1, "certified": false, "reason": "not tried"}
 ],
 "engine": {"method": "exact", "seed": 0},
 "seconds": {"total": 0.001235, "matrices": 0.0001},
 "warnings": ["a warning"]
}
)");
  CHECK(JsonDocument(text).root().members.size() == 10);
}

TEST_CASE("result_json: an infinite result names the component and the status of the rest") {
  Result result;
  result.status = Status::infinite;
  result.rest_status = Status::certified;
  result.variables = {"u", "v"};
  result.common_component = symbolic::Polynomial::variable(2, 0) - symbolic::Polynomial::variable(2, 1);
  const std::string text = result_json(result, std::nullopt);
  CHECK(contains(text, "\"status\": \"infinite\",\n \"rest_status\": \"certified\""));
  CHECK(contains(text, "\"common_component\": \"u - v\""));
  CHECK(contains(text, "\"solutions\": []"));
  CHECK_FALSE(contains(text, "\"id\""));
}

TEST_CASE("result_csv: a header and one line for each solution") {
  CHECK(result_csv(two_points()) ==
        "x_re,x_im,y_re,y_im,radius,real,multiplicity,certified\n"
        "-1.5,0,0.25,0,1e-15,true,2,true\n"
        "0.5,-1.25,0,2,1e-15,undecided,1,false\n");
}

TEST_CASE("result_text: the audit comes first, then what ran, then the table") {
  CHECK(result_text(two_points(), {}, false) ==
        R"(Status: numeric: computed, not proven complete

Count audit, with multiplicity
    4  Bezout number, the product of the degrees
  = 3  finite (2 points)
  + 1  at infinity
    3  finite
  = 2  certified
  + 1  not certified
Points: 1 real, 1 not real, 0 undecided

             given  used
  engine     auto   exact
  matrix     auto   -
  precision  auto   -
  seed       0      0

  #   x            y     multiplicity  real       radius  certified
  1  -1.5          0.25             2  yes        1e-15   yes
  2   0.5 - 1.25i  2i               1  undecided  1e-15   no
Not certified: #2: not tried
)");
}

TEST_CASE("result_text: a sum that fails is named") {
  Result result = two_points();
  result.counts.at_infinity = 0;
  result.solutions.pop_back();
  const std::string text = result_text(result, {});
  CHECK(contains(text, "THE SUM FAILS: finite + at infinity"));
  CHECK(contains(text, "THE SUM FAILS: the multiplicities listed add up to 2"));
}

TEST_CASE("result_text: empty systems and common components are said in words") {
  Result empty;
  empty.counts.bezout_number = empty.counts.at_infinity = 1;
  CHECK(contains(result_text(empty, {}), "no common point in the affine plane: all intersections lie at infinity."));

  Result infinite;
  infinite.status = Status::infinite;
  infinite.common_component = symbolic::Polynomial::variable(2, 0);
  CHECK(contains(result_text(infinite, {}), "common component is a solution:\n  x = 0\n"));
  CHECK(contains(result_text(infinite, {}), "There are no other solutions."));
  infinite.common_component = symbolic::Polynomial(2);
  CHECK(contains(result_text(infinite, {}), "every point of the plane is a solution"));

  Result elsewhere;
  elsewhere.counts = {.distinct = 2, .with_multiplicity = 2, .bezout_number = 2};
  CHECK(contains(result_text(elsewhere, {}), "0 of 2 listed"));
  CHECK(contains(result_text(elsewhere, {}), "None of the 2 points"));
}

TEST_CASE("result_text: numbers too long for a table stand in blocks, unbroken") {
  Result result = two_points();
  result.solutions[0].x.real = "0." + std::string(300, '3');
  const std::string text = result_text(result, {});
  CHECK(contains(text, "  #1  multiplicity 2, real yes, radius 1e-15, certified\n    x = 0." + std::string(300, '3') +
                           "\n    y = 0.25\n"));
}

TEST_CASE("report_error: kind and exit status of every class of error") {
  const auto check = [](const std::exception& error, const char* kind, int status) {
    CHECK(report_error(error).kind == kind);
    CHECK(report_error(error).exit_status == status);
  };
  check(ParseError("m", "e", {1, 2}), "parse_error", 2);
  check(InvalidInput("m"), "invalid_input", 2);
  check(LimitReached("m"), "limit", 3);
  check(PrecisionExhausted("m"), "precision", 3);
  check(std::bad_alloc(), "limit", 3);
  check(OutputError("m"), "output", 1);
  check(std::runtime_error("m"), "internal", 1);
}

TEST_CASE("error_json: all fields, null where nothing is known") {
  const std::string text =
      error_json(report_error(ParseError("bad", "good", {3, 4})), "curve_curve", ProblemId(7L), false);
  CHECK(contains(text, "\"problem\": \"curve_curve\""));
  CHECK(contains(text, "\"status\": \"error\""));
  CHECK(contains(text, "\"id\": 7"));
  CHECK(contains(text,
                 R"("error": {"kind": "parse_error", "message": "bad", "line": 3, "column": 4, "expected": "good"})"));
  const std::string limit = error_json(report_error(LimitReached("m")), std::nullopt, std::nullopt, true);
  CHECK(contains(limit, "\"status\": \"incomplete\""));
  CHECK(contains(limit, "\"problem\": null"));
  CHECK(error_line(report_error(ParseError("bad", "good", {3, 4})), "f.json") == "f.json:3:4: bad; expected good");
}

TEST_CASE("stated_kind: what a text calls itself, also when it is no problem") {
  CHECK(stated_kind(R"({"id": 1, "problem": "curve_surface", "curve": 7})", ProblemSyntax::json) == "curve_surface");
  CHECK(stated_kind("x, y\n0\n", ProblemSyntax::msolve) == "plane_curves");
  for (const char* text : {"", "[]", "{}", R"({"problem": 1})", R"({"problem": "curve_curve")"}) {
    CAPTURE(text);
    CHECK_FALSE(stated_kind(text, ProblemSyntax::json));
  }
  CHECK_FALSE(stated_kind("{\"problem\": \"" + std::string(1000, 'x') + "\"}", ProblemSyntax::json));
}
